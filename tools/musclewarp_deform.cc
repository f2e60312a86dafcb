// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gflags/gflags.h>

#include <iostream>

#include "musclewarp/base/input_error.h"
#include "tools/deform_command.h"
#include "tools/program.h"

DEFINE_string(scene, "", "scene file (JSON)");
DEFINE_string(out, "", "folder for the frames and report.json");
DEFINE_string(data_root,
              "",
              "folder that the paths in the scene are relative to; without it "
              "the folder of the scene file");
DEFINE_string(solver,
              "ceres",
              "ceres, or reference (Gauss-Newton with Lagrange multiplier)");
DEFINE_string(contact, "none", "none: every muscle deforms on its own");
DEFINE_string(frames,
              "all",
              "poses to compute: all, last, N, FIRST:LAST or FIRST:LAST:STEP "
              "(last included)");
DEFINE_string(format, "ply", "mesh files to write: ply, obj, vtp; commas");
DEFINE_int32(threads, 0, "threads; 0: one a core");
DEFINE_int32(coarse_vertices, 200, "vertices of the hull of a muscle, about");
DEFINE_double(sample_spacing, 10, "distance of samples along a line, mm");
DEFINE_double(skeleton_weight,
              1,
              "how strongly a muscle follows its lines, against its shape");
DEFINE_double(attachment_weight,
              0,
              "how strongly attachment areas follow their bones; 0: not");
DEFINE_bool(body_twist,
            true,
            "muscles turn about their lines as the bones at the ends do");

namespace musclewarp {
namespace {

DeformOptions OptionsFromFlags() {
  if (FLAGS_contact != "none") {
    throw InputError("--contact=" + FLAGS_contact,
                     "is not something this version does",
                     "allowed: none");
  }
  DeformOptions options;
  options.scene = FLAGS_scene;
  options.out = FLAGS_out;
  options.data_root = FLAGS_data_root;
  options.solver = ParseDeformSolver(FLAGS_solver);
  options.frames = FLAGS_frames;
  options.formats = ParseFormats(FLAGS_format);
  options.threads = FLAGS_threads;
  options.prepare.muscle.hull.coarse_vertices = FLAGS_coarse_vertices;
  options.prepare.muscle.sample_spacing = FLAGS_sample_spacing;
  options.prepare.muscle.skeleton_weight = FLAGS_skeleton_weight;
  options.prepare.muscle.attachment_weight = FLAGS_attachment_weight;
  options.pre_rotation.use_body_twist = FLAGS_body_twist;
  return options;
}

}  // namespace
}  // namespace musclewarp

int main(int argc, char** argv) {
  return musclewarp::RunProgram(
      argc,
      argv,
      "musclewarp-deform --scene=FILE --out=DIR [flags]\n\n"
      "Deforms the muscles of a scene so that they follow their lines of "
      "action and\nkeep their volume. Writes DIR/frame_0000/<name>.ply, ..., "
      "and DIR/report.json.\nExit code: 0 usable, 1 not usable (the summary "
      "says why), 2 bad input.",
      [](const std::vector<std::string>& arguments) {
        musclewarp::RefuseArguments(arguments);
        return musclewarp::DeformCommand(musclewarp::OptionsFromFlags(),
                                         std::cout);
      });
}
