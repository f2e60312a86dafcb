// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gflags/gflags.h>

#include <iostream>

#include "tools/export_command.h"
#include "tools/program.h"

DEFINE_string(
    in,
    "",
    "folder written by musclewarp-deform; for osim several with commas");
DEFINE_string(out, "", "the file (glb, osim) or the folder (else) to write");
DEFINE_string(format,
              "",
              "crossings: places where meshes cross; glb: glTF 2.0; pc2: .obj "
              "and point caches for Blender; osim: the OpenSim model with path "
              "functions; inp, feb, msh and with VTK vtu: "
              "finite elements, several with commas");
DEFINE_string(frames,
              "all",
              "which frames: all, last, N, FIRST:LAST, FIRST:LAST:STEP; FIRST "
              "and LAST may be times (0.1s)");
DEFINE_string(mesh_format, "ply", "of crossings: ply, obj, and with VTK vtp");
DEFINE_string(mesher,
              "tetgen",
              "the program that makes tetrahedra: tetgen, gmsh, or the path of "
              "one");
DEFINE_double(mesher_timeout_s, 600, "s; a frame that takes longer fails");
DEFINE_double(min_dihedral_deg,
              0,
              "degrees; frames with a smaller angle between faces fail");
DEFINE_bool(bones, true, "bones as rigid surfaces beside the tetrahedra");
DEFINE_bool(one_mesh,
            false,
            "the tetrahedra of the first frame, moved to the others");
DEFINE_bool(resume,
            false,
            "keep the tetrahedra of frames that are there from a run with the "
            "same flags");
DEFINE_string(model,
              "",
              "of osim: the model, in place of the one that the run keeps");
DEFINE_double(max_length_error_mm,
              0.5,
              "of osim: mm; exit code 1 if a length is fitted worse");
DEFINE_double(max_arm_error_mm,
              1,
              "of osim: mm; exit code 1 if a moment arm is fitted worse");
DEFINE_int32(threads, 0, "threads; 0: one a core");

namespace musclewarp {
namespace {

ExportRequest RequestFromFlags(const std::vector<std::string>& files) {
  ExportRequest request;
  request.in = FLAGS_in;
  request.files = files;
  request.out = FLAGS_out;
  request.format = FLAGS_format;
  request.frames = FLAGS_frames;
  request.mesh_format = FLAGS_mesh_format;
  request.threads = FLAGS_threads;
  request.elements.mesher = FLAGS_mesher;
  request.elements.mesher_timeout_s = FLAGS_mesher_timeout_s;
  request.elements.min_dihedral_deg = FLAGS_min_dihedral_deg;
  request.elements.bones = FLAGS_bones;
  request.elements.one_mesh = FLAGS_one_mesh;
  request.elements.resume = FLAGS_resume;
  request.osim.model = FLAGS_model;
  request.osim.fit.max_length_error = FLAGS_max_length_error_mm;
  request.osim.fit.max_arm_error = FLAGS_max_arm_error_mm;
  return request;
}

}  // namespace
}  // namespace musclewarp

int main(int argc, char** argv) {
  return musclewarp::RunProgram(
      argc,
      argv,
      "musclewarp-export --in=RUN --out=... --format=FORMAT [flags]\n"
      "       musclewarp-export MESH... --out=DIR --format=crossings\n\n"
      "Writes a run for other programs (docs/export.md).\n"
      "Exit code: 0 done, 1 a frame could not be meshed or a fit exceeds its "
      "bounds, 2 bad input.",
      [](const std::vector<std::string>& files) {
        return musclewarp::ExportCommand(musclewarp::RequestFromFlags(files),
                                         std::cout);
      });
}
