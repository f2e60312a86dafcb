// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <iostream>

#include "musclewarp/program/flags.h"
#include "musclewarp/program/program.h"
#include "tools/report_command.h"

namespace {

const musclewarp::ProgramText kText = {
    "musclewarp-report --in=DIR [--compare=DIR] [--out=report.html]\n\n"
    "Turns a run of musclewarp-deform into one HTML page with a 3D viewer, "
    "plots and a\nsummary. The page needs nothing beside it and no network; "
    "runs that did not get to\ntheir end are shown as far as they came.\n"
    "Exit code: 0 written, 2 bad input.",
    {{"musclewarp-report --in=run", "writes run/report.html"},
     {"musclewarp-report --in=run --compare=other --out=both.html",
      "shows two runs side by side"}},
    {"in", "out", "compare", "overlay"}};

}  // namespace

int main(int argc, char** argv) {
  using namespace musclewarp;
  ReportRequest request;
  RegisterFlags(&request);
  return RunProgram(
      argc, argv, kText, [&](const std::vector<std::string>& arguments) {
        RefuseArguments(arguments);
        WriteReport(request, std::cout);
        return kExitUsable;
      });
}
