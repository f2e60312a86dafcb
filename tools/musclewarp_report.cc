// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gflags/gflags.h>

#include <iostream>

#include "tools/program.h"
#include "tools/report_command.h"

DEFINE_string(in, "", "folder of a run of musclewarp-deform");
DEFINE_string(compare, "", "folder of another run, to show beside it");
DEFINE_string(out, "report.html", "the page to write");
DEFINE_int32(bone_triangles,
             musclewarp::PageOptions().max_bone_triangles,
             "bones are shown with at most about so many triangles each");
DEFINE_string(axes,
              "",
              "where +x, +y, +z of the meshes point: L or R, A or P, S or I "
              "(OpenSim: ASR); default: as the scene says");
DEFINE_string(side,
              "",
              "side of the body, right or left, that lateral and medial mean; "
              "default: as the scene says");

int main(int argc, char** argv) {
  return musclewarp::RunProgram(
      argc,
      argv,
      "musclewarp-report --in=DIR [--compare=DIR] [--out=report.html]\n\n"
      "Turns a run of musclewarp-deform into one HTML page with a 3D viewer, "
      "plots and a\nsummary. The page needs nothing beside it and no network; "
      "runs that did not get to\ntheir end are shown as far as they came.\n"
      "Exit code: 0 written, 2 bad input.",
      [](const std::vector<std::string>& arguments) {
        musclewarp::RefuseArguments(arguments);
        musclewarp::ReportRequest request;
        request.in = FLAGS_in;
        request.compare = FLAGS_compare;
        request.out = FLAGS_out;
        request.page.max_bone_triangles = FLAGS_bone_triangles;
        request.page.axes = FLAGS_axes;
        request.page.side = FLAGS_side;
        musclewarp::WriteReport(request, std::cout);
        return musclewarp::kExitUsable;
      });
}
