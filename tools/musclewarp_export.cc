// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <iostream>

#include "musclewarp/program/flags.h"
#include "musclewarp/program/program.h"
#include "tools/export_command.h"

namespace {

const musclewarp::ProgramText kText = {
    "musclewarp-export --in=RUN --out=... --format=FORMAT [flags]\n"
    "       musclewarp-export MESH... --out=DIR --format=crossings\n\n"
    "Writes a run for other programs (docs/export.md).\n"
    "Exit code: 0 done, 1 a frame could not be meshed or a fit exceeds its "
    "bounds, 2 bad input.",
    {{"musclewarp-export --in=run --out=run.csv --format=csv",
      "writes lengths, moment arms and volumes as one table"},
     {"musclewarp-export --in=run --out=run.glb --format=glb --frames=0:10",
      "writes eleven frames as glTF, for Blender and browsers"}},
    {"in", "out", "format", "frames"}};

}  // namespace

int main(int argc, char** argv) {
  musclewarp::ExportRequest request;
  musclewarp::RegisterFlags(&request);
  musclewarp::RegisterFlags(&request.elements);
  musclewarp::RegisterFlags(&request.paths);
  return musclewarp::RunProgram(
      argc, argv, kText, [&](const std::vector<std::string>& arguments) {
        request.files = arguments;
        return musclewarp::ExportCommand(request, std::cout);
      });
}
