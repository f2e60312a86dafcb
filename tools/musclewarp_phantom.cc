// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gflags/gflags.h>

#include <iostream>

#include "tools/phantom_command.h"
#include "tools/program.h"

DEFINE_string(out, "", "folder to write to; made if need be");
DEFINE_string(scene,
              "hip",
              "which scene: hip, or one that is hard on contact: "
              "stress_attachment, stress_edge, stress_plate, "
              "stress_resolution, stress_sheet, stress_sweep, or random, an "
              "anatomy that is drawn from the seed");
DEFINE_uint32(seed,
              1,
              "places of the planted defects and bumps of the surfaces; in the "
              "scene random everything");
DEFINE_int32(num_muscles,
             0,
             "number of muscles of the scene random, 2 to 32; 0: drawn from "
             "the seed, 2 to 20");

int main(int argc, char** argv) {
  return musclewarp::RunProgram(
      argc,
      argv,
      "musclewarp-phantom --out=DIR [flags]\n\n"
      "Writes a made-up scene of muscles and bones, the same bytes for the "
      "same seed:\nDIR/scene.json, and DIR/<name>.ply for every mesh. The "
      "meshes have defects, as\nsegmented ones do.\n"
      "Exit code: 0 written, 2 bad input.",
      [](const std::vector<std::string>& arguments) {
        musclewarp::RefuseArguments(arguments);
        musclewarp::PhantomRequest request;
        request.out = FLAGS_out;
        request.scene = FLAGS_scene;
        request.seed = FLAGS_seed;
        request.num_muscles = FLAGS_num_muscles;
        musclewarp::MakePhantom(request, std::cout);
        return musclewarp::kExitUsable;
      });
}
