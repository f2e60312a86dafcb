// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "musclewarp/base/described.h"

namespace musclewarp {

// The settings of musclewarp-render.
struct RenderRequest {
  std::string in;
  std::string out;
  std::string frames = "0";
  std::string captions = "auto";
  std::string view = "anterior";
  std::string axes;
  std::string side;
  std::string size = "1200x1000";
  std::string bones;
  std::string hide;
  std::string fade;
  std::string fit;
  std::string color = "muscle";
  bool legend = true;
  bool outlines = true;
  std::vector<std::string> files;  // meshes in place of those in `in`
};

constexpr auto FieldsOf(Described<RenderRequest>) {
  using S = RenderRequest;
  return std::make_tuple(
      Field(&S::in, "in")
          .Text("folder written by musclewarp-deform, or any folder of meshes")
          .Path(),
      Field(&S::out, "out").Text("the picture, a .png file").Path(),
      Field(&S::frames, "frames")
          .Text("frames of {in}, side by side: numbers or 'last', with commas"),
      Field(&S::captions, "captions")
          .Text("texts below the frames, with commas; auto: if there are "
                "several frames, the values of the coordinates that move, or "
                "the names in report.json"),
      Field(&S::view, "view")
          .Text("from where: anterior, posterior, lateral, medial, left, "
                "right, superior, inferior, or a direction towards the viewer "
                "in the axes of the meshes, x,y,z or x,y,z;upx,upy,upz"),
      Field(&S::axes, "axes")
          .Text("where +x, +y, +z of the meshes point in the body, a letter "
                "each out of L R A P S I: LPS for CT, MRI and BodyParts3D, ASR "
                "for OpenSim; default: as the run says, else LPS"),
      Field(&S::side, "side")
          .Text("side of the body that lateral and medial mean; default: as "
                "the run says, else right"),
      Field(&S::size, "size").Text("width and height of the picture, pixels"),
      Field(&S::bones, "bones")
          .Text("names of the bones, with commas, where no report.json tells"),
      Field(&S::hide, "hide").Text("names of meshes to leave out, with commas"),
      Field(&S::fade, "fade")
          .Text("meshes to see through, as name:opacity, with commas; opacity "
                "from 0 to 1"),
      Field(&S::fit, "fit")
          .Text("names of meshes the picture is made to hold, with commas; "
                "without it all"),
      Field(&S::color, "color")
          .Text("what the colours of muscles tell: muscle (which it is) or "
                "stretch (how far each triangle is stretched against rest, for "
                "a run of musclewarp-deform)")
          .OneOf("muscle, stretch"),
      Field(&S::legend, "legend")
          .Text("name the muscles below the picture, or what the colours tell"),
      Field(&S::outlines, "outlines").Text("draw dark outlines"),
      NotWritten(&S::files));
}

// Draws the picture, and names the written file on `log`. Throws InputError,
// naming the flag or the file, before anything is written.
void Render(const RenderRequest& request, std::ostream& log);

}  // namespace musclewarp
