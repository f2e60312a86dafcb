// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/literature_command.h"

#include <algorithm>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "musclewarp/base/csv_field.h"
#include "musclewarp/base/input_error.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/page/measured_arms.h"
#include "musclewarp/run/output_folder.h"
#include "musclewarp/run/run_reader.h"
#include "musclewarp/settings/checked_settings.h"
#include "musclewarp/studies/literature_score.h"

namespace musclewarp {
namespace {

std::string Fixed(double value, int digits) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

std::string Range(double low, double high) {
  return Fixed(low, 0) + " to " + Fixed(high, 0);
}

std::string TrendText(const ArmVerdict& verdict) {
  if (!verdict.has_trend) return "";
  return *verdict.has_trend ? "yes" : "no";
}

// Returns what a verdict finds fault with, or "holds".
std::string FaultsOf(const ArmVerdict& verdict) {
  std::string faults;
  const auto add = [&](const std::string& fault) {
    faults += (faults.empty() ? "" : ", ") + fault;
  };
  if (verdict.inside < 1) {
    add(Fixed(100 * (1 - verdict.inside), 0) + " % outside");
  }
  if (!verdict.has_sign) add("sign");
  if (!verdict.has_trend.value_or(true)) add("trend");
  return faults.empty() ? "holds" : faults;
}

void PrintTable(const std::vector<ScoredMuscle>& scored, std::ostream& screen) {
  size_t width = 0;
  for (const ScoredMuscle& row : scored) {
    width = std::max({width, row.muscle.size(), row.coordinate.size()});
  }
  const auto cell = [&](const std::string& text, size_t columns) {
    screen << std::left << std::setw(static_cast<int>(columns + 2)) << text;
  };
  const auto line = [&](const std::vector<std::string>& cells) {
    const std::vector<size_t> widths = {width, width, 10, 7, 12, 12, 12};
    for (size_t i = 0; i < cells.size(); ++i) {
      i < widths.size() ? cell(cells[i], widths[i]) : cell(cells[i], 0);
    }
    screen << "\n";
  };
  line({"muscle",
        "coordinate",
        "degrees",
        "values",
        "measured mm",
        "path mm",
        "carried mm",
        "path; carried"});
  for (const ScoredMuscle& row : scored) {
    line({row.muscle,
          row.coordinate,
          Range(row.first_deg, row.last_deg),
          std::to_string(row.values),
          Range(row.measured_low_mm, row.measured_high_mm),
          Range(row.path.low_mm, row.path.high_mm),
          Range(row.carried.low_mm, row.carried.high_mm),
          FaultsOf(row.path) + "; " + FaultsOf(row.carried)});
  }
}

std::string CsvOf(const std::vector<ScoredMuscle>& scored) {
  std::ostringstream csv;
  csv << "muscle,measured,coordinate,turned,values,studies,first_deg,last_deg,"
         "measured_low_mm,measured_high_mm";
  for (const char* kind : {"path", "carried"}) {
    for (const char* figure :
         {"low_mm", "high_mm", "inside", "sign", "trend", "holds"}) {
      csv << "," << kind << "_" << figure;
    }
  }
  csv << "\n";
  for (const ScoredMuscle& row : scored) {
    csv << SpreadsheetField(row.muscle) << "," << SpreadsheetField(row.measured)
        << "," << SpreadsheetField(row.coordinate) << ","
        << (row.turned ? "yes" : "no") << "," << row.values << ","
        << row.studies << "," << row.first_deg << "," << row.last_deg << ","
        << row.measured_low_mm << "," << row.measured_high_mm;
    for (const ArmVerdict* verdict : {&row.path, &row.carried}) {
      csv << "," << Fixed(verdict->low_mm, 2) << ","
          << Fixed(verdict->high_mm, 2) << "," << Fixed(verdict->inside, 3)
          << "," << (verdict->has_sign ? "yes" : "no") << ","
          << TrendText(*verdict) << "," << (verdict->Holds() ? "yes" : "no");
    }
    csv << "\n";
  }
  return csv.str();
}

void CheckOptions(const LiteratureOptions& options) {
  CheckSettings<LiteratureSettings>(options);
  if (options.in.empty()) {
    throw InputError("--literature=" + options.literature,
                     "needs a run to compare with",
                     "give the folder of a run of musclewarp-deform with --in");
  }
}

}  // namespace

int LiteratureCommand(const LiteratureOptions& options, std::ostream& screen) {
  CheckOptions(options);
  const MeasuredArms measured = ReadMeasuredArms(options.literature);
  const JsonField report = ReadReport(options.in);
  const RunOutline run = OutlineOf(options.in, report);
  if (!options.out.empty()) CheckWritable(options.out);
  std::vector<FrameFigures> frames;
  for (const RecordedFrame& frame : run.frames) frames.push_back(frame.figures);
  ArmsOfRun arms;
  AddArms(MovingRotations(report.value()), frames, &arms);
  const std::vector<ScoredMuscle> scored = ScoreArms(measured, arms, frames);
  if (scored.empty()) {
    throw InputError(options.literature,
                     "has no measured moment arm of a muscle and a coordinate "
                     "that move in " +
                         options.in,
                     "compare it with a run that moves the joint, and whose "
                     "muscles have their usual names");
  }
  PrintTable(scored, screen);
  const auto held =
      std::count_if(scored.begin(), scored.end(), [](const ScoredMuscle& row) {
        return row.path.Holds();
      });
  const auto carried =
      std::count_if(scored.begin(), scored.end(), [](const ScoredMuscle& row) {
        return row.carried.Holds();
      });
  screen << "\nof " << scored.size() << " rows " << held
         << " hold as paths, and " << carried << " as the muscles carry them\n";
  if (!options.out.empty()) {
    MakeFolder(options.out);
    WriteTextAtomically(options.out + "/literature.csv", CsvOf(scored));
    screen << "table: " << options.out << "/literature.csv\n";
  }
  return 0;
}

}  // namespace musclewarp
