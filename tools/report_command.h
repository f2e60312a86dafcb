// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>

#include "musclewarp/page/page_contents.h"

namespace musclewarp {

// What musclewarp-report is asked for; the fields are its flags.
struct ReportRequest {
  std::string in;       // a folder that musclewarp-deform wrote
  std::string compare;  // another, to show beside it; empty: none
  std::string out;      // the page, .html
  PageOptions page;
};

// Writes the page and says on `log` what was written. Throws InputError that
// names the flag or the file; nothing is written then.
void WriteReport(const ReportRequest& request, std::ostream& log);

// Writes DIR/report.html for the run in DIR.
void WriteRunPage(const std::string& dir, std::ostream& log);

}  // namespace musclewarp
