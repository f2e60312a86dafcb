// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <iostream>

#include "musclewarp/program/flags.h"
#include "musclewarp/program/program.h"
#include "tools/phantom_command.h"

namespace {

const musclewarp::ProgramText kText = {
    "musclewarp-phantom --out=DIR [flags]\n\n"
    "Writes a made-up scene of muscles and bones, the same bytes for the "
    "same seed:\nDIR/scene.json, and DIR/<name>.ply for every mesh. The "
    "meshes have defects, as\nsegmented ones do.\n"
    "Exit code: 0 written, 2 bad input.",
    {{"musclewarp-phantom --out=hip",
      "writes a hip of a few muscles and bones"},
     {"musclewarp-phantom --out=drawn --scene=random --seed=7",
      "writes a scene that is drawn from the seed"}},
    {"out", "scene", "seed"}};

}  // namespace

int main(int argc, char** argv) {
  using namespace musclewarp;
  PhantomRequest request;
  RegisterFlags(&request);
  return RunProgram(
      argc, argv, kText, [&](const std::vector<std::string>& arguments) {
        RefuseArguments(arguments);
        MakePhantom(request, std::cout);
        return kExitUsable;
      });
}
