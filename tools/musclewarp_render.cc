// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gflags/gflags.h>

#include <iostream>

#include "tools/program.h"
#include "tools/render_command.h"

DEFINE_string(in,
              "",
              "folder written by musclewarp-deform, or any folder of meshes");
DEFINE_string(out, "", "the picture, a .png file");
DEFINE_string(frames,
              "0",
              "frames of --in, side by side: numbers or 'last', with commas");
DEFINE_string(captions,
              "auto",
              "texts below the frames, with commas; auto: the names in "
              "report.json if there are several frames");
DEFINE_string(view,
              "anterior",
              "from where: anterior, posterior, lateral, medial, left, right, "
              "superior, inferior, or a direction towards the viewer in the "
              "axes of the meshes, x,y,z or x,y,z;upx,upy,upz");
DEFINE_string(axes,
              "",
              "where +x, +y, +z of the meshes point in the body, a letter each "
              "out of L R A P S I: LPS for CT, MRI and BodyParts3D, ASR for "
              "OpenSim; default: as the run says, else LPS");
DEFINE_string(side,
              "",
              "side of the body that lateral and medial mean; default: as the "
              "run says, else right");
DEFINE_string(size, "1200x1000", "width and height of the picture, pixels");
DEFINE_string(bones,
              "",
              "names of the bones, with commas, where no report.json tells");
DEFINE_string(hide, "", "names of meshes to leave out, with commas");
DEFINE_string(fade,
              "",
              "meshes to see through, as name:opacity, with commas; opacity "
              "from 0 to 1");
DEFINE_string(fit,
              "",
              "names of meshes the picture is made to hold, with commas; "
              "without it all");
DEFINE_string(color,
              "muscle",
              "what the colours of muscles tell: muscle (which it is) or "
              "stretch (how far each triangle is stretched against rest, for a "
              "run of musclewarp-deform)");
DEFINE_bool(legend,
            true,
            "name the muscles below the picture, or what the colours tell");
DEFINE_bool(outlines, true, "draw dark outlines");

namespace musclewarp {
namespace {

RenderRequest RequestFromFlags(const std::vector<std::string>& files) {
  RenderRequest request;
  request.in = FLAGS_in;
  request.files = files;
  request.out = FLAGS_out;
  request.frames = FLAGS_frames;
  request.captions = FLAGS_captions;
  request.view = FLAGS_view;
  request.axes = FLAGS_axes;
  request.side = FLAGS_side;
  request.size = FLAGS_size;
  request.bones = FLAGS_bones;
  request.hide = FLAGS_hide;
  request.fade = FLAGS_fade;
  request.fit = FLAGS_fit;
  request.color = FLAGS_color;
  request.legend = FLAGS_legend;
  request.outlines = FLAGS_outlines;
  return request;
}

}  // namespace
}  // namespace musclewarp

int main(int argc, char** argv) {
  return musclewarp::RunProgram(
      argc,
      argv,
      "musclewarp-render --out=FILE.png --in=DIR [flags]\n"
      "       musclewarp-render --out=FILE.png [flags] MESH...\n\n"
      "Draws frames of a run, or any meshes, side by side with one camera: "
      "muscles in\nreds that stay apart for the colour-blind, bones in ivory. "
      "Needs no display.\nExit code: 0 done, 2 bad input or no OpenGL.",
      [](const std::vector<std::string>& arguments) {
        musclewarp::Render(musclewarp::RequestFromFlags(arguments), std::cout);
        return musclewarp::kExitUsable;
      });
}
