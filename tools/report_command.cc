// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/report_command.h"

#include <filesystem>
#include <vector>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/base/text.h"
#include "musclewarp/geometry/view.h"
#include "musclewarp/page/page.h"
#include "musclewarp/page/path_table.h"
#include "musclewarp/settings/checked_settings.h"

namespace musclewarp {
namespace {

std::string Mebibytes(std::size_t bytes) {
  return RoundedText(static_cast<double>(bytes) / (1 << 20), 1) + " MiB";
}

}  // namespace

void WriteReport(const ReportRequest& request, std::ostream& log) {
  if (request.in.empty()) {
    throw InputError(
        "--in", "is missing", "give the folder of a run of musclewarp-deform");
  }
  if (std::filesystem::path(request.out).extension() != ".html") {
    throw InputError("--out",
                     "'" + request.out + "' is not a .html file",
                     "use --out=report.html");
  }
  CheckSettings(request);
  // Throws InputError for a bad flag before the work starts.
  ParseView("anterior",
            request.page.axes.empty() ? "LPS" : request.page.axes,
            request.page.side.empty() ? "right" : request.page.side);
  PageOptions page = request.page;
  if (!request.fit.empty()) page.path_table = PathTableOf(request.fit);
  if (!request.overlay.empty()) {
    page.measured = ReadMeasuredArms(request.overlay);
  }
  std::vector<RecordedRun> runs = {ReadRecordedRun(request.in, log)};
  if (!request.compare.empty()) {
    runs.push_back(ReadRecordedRun(request.compare, log));
  }
  for (const RecordedRun& run : runs) {
    for (const std::string& warning : run.warnings) {
      log << "warning: " << run.dir << ": " << warning << "\n";
    }
  }
  if (!request.overlay.empty()) {
    log << request.overlay << ": " << MeasuredNote(page.measured, ArmsOf(runs))
        << "\n";
  }
  const std::string html = PageHtml(runs, page);
  WriteTextAtomically(request.out, html);
  log << "wrote " << request.out << " (" << Mebibytes(html.size()) << ")\n";
}

void WriteRunPage(const std::string& dir, std::ostream& log) {
  ReportRequest request;
  request.in = dir;
  request.out = (std::filesystem::path(dir) / "report.html").string();
  WriteReport(request, log);
}

}  // namespace musclewarp
