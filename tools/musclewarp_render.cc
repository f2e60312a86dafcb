// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <iostream>

#include "musclewarp/program/flags.h"
#include "musclewarp/program/program.h"
#include "tools/render_command.h"

namespace {

const musclewarp::ProgramText kText = {
    "musclewarp-render --out=FILE.png --in=DIR [flags]\n"
    "       musclewarp-render --out=FILE.png [flags] MESH...\n\n"
    "Draws frames of a run, or any meshes, side by side with one camera: "
    "muscles in\nreds that stay apart for the colour-blind, bones in ivory. "
    "Needs no display.\nExit code: 0 done, 2 bad input or no OpenGL.",
    {{"musclewarp-render --out=run.png --in=run --frames=0,last",
      "draws the first and the last frame of a run side by side"},
     {"musclewarp-render --out=meshes.png psoas.ply femur.ply",
      "draws two meshes"}},
    {"in", "out", "frames", "view", "hide"}};

}  // namespace

int main(int argc, char** argv) {
  using namespace musclewarp;
  RenderRequest request;
  RegisterFlags(&request);
  return RunProgram(
      argc, argv, kText, [&](const std::vector<std::string>& arguments) {
        request.files = arguments;
        Render(request, std::cout);
        return kExitUsable;
      });
}
