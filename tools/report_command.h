// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>

#include "musclewarp/base/described.h"
#include "musclewarp/page/page_contents.h"

namespace musclewarp {

// What musclewarp-report is asked for; the fields are its flags.
struct ReportRequest {
  std::string in;
  std::string compare;
  std::string out = "report.html";
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

// Writes the page and says on `log` what was written. Throws InputError that
// names the flag or the file; nothing is written then.
void WriteReport(const ReportRequest& request, std::ostream& log);

// Writes DIR/report.html for the run in DIR.
void WriteRunPage(const std::string& dir, std::ostream& log);

}  // namespace musclewarp
