// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>

#include "musclewarp/base/described.h"
#include "musclewarp/page/page_contents.h"

namespace musclewarp {

// The settings of musclewarp-report.
struct ReportRequest {
  std::string in;
  std::string compare;
  std::string out = "report.html";
  std::string overlay;
  std::string fit;
  PageOptions page;
};

constexpr auto FieldsOf(Described<ReportRequest>) {
  using S = ReportRequest;
  using P = PageOptions;
  return std::make_tuple(
      Field(&S::in, "in").Text("folder of a run of musclewarp-deform").Path(),
      Field(&S::compare, "compare")
          .Text("folder of another run, to show beside it")
          .Path(),
      Field(&S::out, "out").Text("the page to write").Path(),
      Field(&S::overlay, "overlay")
          .Text("measured moment arms to lay over the plots: a CSV table with "
                "the columns coordinate, muscle, angle_deg, moment_arm_mm, ...")
          .Path(),
      Field(&S::fit, "fit")
          .Text("path functions of the run to list: a .json file of "
                "musclewarp-export")
          .Path(),
      Field(Inner(&S::page, &P::max_bone_triangles), "bone_triangles")
          .Text("bones are shown with at most about so many triangles each")
          .AtLeast(100),
      Field(Inner(&S::page, &P::axes), "axes")
          .Text("where +x, +y, +z of the meshes point: L or R, A or P, S or I "
                "(OpenSim: ASR); default: as the scene says"),
      Field(Inner(&S::page, &P::side), "side")
          .Text("side of the body, right or left, that lateral and medial "
                "mean; default: as the scene says"),
      NotWritten(&S::page));
}

// Writes the page, and names the written file on `log`. Throws InputError,
// naming the flag or the file, before anything is written.
void WriteReport(const ReportRequest& request, std::ostream& log);

// Writes the page of the run in `dir` to report.html in the same folder.
void WriteRunPage(const std::string& dir, std::ostream& log);

}  // namespace musclewarp
