// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/studies/convergence_table.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

#include "musclewarp/base/csv_field.h"
#include "musclewarp/base/text.h"

namespace musclewarp {
namespace {

using Json = nlohmann::ordered_json;

std::string TitleOf(StudyKind study) {
  switch (study) {
    case StudyKind::kVertices:
      return "Size of hulls ({convergence_vertices})";
    case StudyKind::kSpacing:
      return "Spacing of samples, mm ({convergence_spacing})";
    case StudyKind::kDensity:
      return "Density of fine meshes ({convergence_density})";
  }
  return "";
}

// The widths of the columns that contain texts.
struct TextWidths {
  int pose = 6, muscle = 8;
};

TextWidths WidthsOf(const std::vector<ConvergenceRow>& rows) {
  TextWidths widths;
  for (const ConvergenceRow& row : rows) {
    widths.pose = std::max(widths.pose, static_cast<int>(row.pose.size()) + 2);
    widths.muscle =
        std::max(widths.muscle, static_cast<int>(row.muscle.size()) + 2);
  }
  return widths;
}

void PrintHeader(StudyKind study, TextWidths widths, std::ostream& out) {
  out << "\n"
      << TitleOf(study) << "\n"
      << std::left << std::setw(widths.pose) << "pose"
      << std::setw(widths.muscle) << "muscle" << std::right << std::setw(8)
      << "value"
      << "    hull samples vertices  largest mm  mean mm      volume"
         "  stretch:mean    99 %  99.9 % largest  arm mm        ms  usable\n";
}

void PrintRow(const ConvergenceRow& row, TextWidths widths, std::ostream& out) {
  const auto figure = [&](double value, int width, int decimals) {
    out << std::setw(width) << RoundedText(value, decimals);
  };
  out << std::left << std::setw(widths.pose) << row.pose
      << std::setw(widths.muscle) << row.muscle << std::right << std::setw(8)
      << NumberText(row.value);
  if (!row.failure.empty()) {
    out << "  failed: " << row.failure << "\n";
    return;
  }
  out << std::setw(8) << row.coarse_vertices << std::setw(8) << row.samples
      << std::setw(9) << row.fine_vertices;
  figure(row.largest_distance, 12, 3);
  figure(row.mean_distance, 9, 3);
  figure(row.volume_ratio, 12, 8);
  figure(row.stretch.mean, 14, 3);
  figure(row.stretch.quantile_99, 8, 3);
  figure(row.stretch.quantile_999, 8, 3);
  figure(row.stretch.largest, 8, 3);
  out << std::setw(8)
      << (row.moment_arm_difference ? RoundedText(*row.moment_arm_difference, 3)
                                    : "-");
  figure(row.ms, 10, 1);
  out << std::setw(8) << (row.is_usable ? "yes" : "no")
      << (row.is_finest ? "  finest" : "") << (row.is_as_set ? "  as set" : "")
      << "\n";
}

// Returns the error of a muscle in one study, or an empty text if the study has
// no row of the muscle.
std::string ErrorOf(const std::vector<ConvergenceRow>& rows,
                    StudyKind study,
                    const std::string& muscle) {
  double largest = 0, mean = 0;
  const ConvergenceRow* as_set = nullptr;
  const ConvergenceRow* finest = nullptr;
  for (const ConvergenceRow& row : rows) {
    if (row.study != study) continue;
    if (row.is_as_set) as_set = &row;
    if (row.is_finest) finest = &row;
    if (!row.is_as_set || row.muscle != muscle) continue;
    largest = std::max(largest, row.largest_distance);
    mean = std::max(mean, row.mean_distance);
  }
  if (!as_set) return "";
  const std::string what = Describe(study, as_set->value);
  if (!as_set->failure.empty()) return what + ": could not be solved";
  if (as_set->is_finest) return what + ": the finest of the study";
  return what + ": " + RoundedText(mean, 2) + " mm on the mean, " +
         RoundedText(largest, 2) + " mm at most, from " +
         NumberText(finest->value);
}

Json ToJson(const ConvergenceRow& row) {
  Json json = {{"study", ToString(row.study)},
               {"value", row.value},
               {"as_set", row.is_as_set},
               {"finest", row.is_finest},
               {"failure", row.failure}};
  if (!row.failure.empty()) return json;
  json.update({{"frame", row.frame},
               {"pose", row.pose},
               {"muscle", row.muscle},
               {"coarse_vertices", row.coarse_vertices},
               {"samples", row.samples},
               {"fine_vertices", row.fine_vertices},
               {"made_anew", row.is_reconstructed},
               {"rest_distance_mm", row.rest_distance},
               {"largest_distance_mm", row.largest_distance},
               {"mean_distance_mm", row.mean_distance},
               {"volume_ratio", row.volume_ratio},
               {"stretch_mean", row.stretch.mean},
               {"stretch_99", row.stretch.quantile_99},
               {"stretch_999", row.stretch.quantile_999},
               {"stretch_largest", row.stretch.largest},
               {"moment_arm_difference_mm", nullptr},
               {"ms", row.ms},
               {"usable", row.is_usable}});
  if (row.moment_arm_difference) {
    json["moment_arm_difference_mm"] = *row.moment_arm_difference;
  }
  return json;
}

// Returns the columns of the CSV file: the keys of a row.
std::vector<std::string> Columns() {
  std::vector<std::string> columns;
  const Json row = ToJson(ConvergenceRow());
  for (const auto& item : row.items()) columns.push_back(item.key());
  return columns;
}

std::string CsvValue(const Json& row, const std::string& column) {
  if (!row.contains(column) || row[column].is_null()) return "";
  const Json& value = row[column];
  return value.is_string() ? CsvField(value.get<std::string>()) : value.dump();
}

}  // namespace

std::string Describe(StudyKind study, double value) {
  switch (study) {
    case StudyKind::kVertices:
      return "hulls of " + NumberText(value) + " vertices";
    case StudyKind::kSpacing:
      return "samples every " + NumberText(value) + " mm";
    case StudyKind::kDensity:
      return "meshes of density " + NumberText(value);
  }
  return "";
}

void PrintConvergence(const std::vector<ConvergenceRow>& rows,
                      std::ostream& out) {
  const TextWidths widths = WidthsOf(rows);
  for (size_t i = 0; i < rows.size(); ++i) {
    if (i == 0 || rows[i].study != rows[i - 1].study) {
      PrintHeader(rows[i].study, widths, out);
    }
    PrintRow(rows[i], widths, out);
  }
}

void PrintErrors(const std::vector<ConvergenceRow>& rows, std::ostream& out) {
  std::vector<std::string> muscles;
  for (const ConvergenceRow& row : rows) {
    if (row.failure.empty() &&
        std::find(muscles.begin(), muscles.end(), row.muscle) ==
            muscles.end()) {
      muscles.push_back(row.muscle);
    }
  }
  for (const std::string& muscle : muscles) {
    std::string text;
    for (const StudyKind study :
         {StudyKind::kVertices, StudyKind::kSpacing, StudyKind::kDensity}) {
      const std::string error = ErrorOf(rows, study, muscle);
      if (!error.empty()) text += (text.empty() ? ": " : "; ") + error;
    }
    out << muscle << text << "\n";
  }
}

std::string ConvergenceCsv(const std::vector<ConvergenceRow>& rows) {
  const std::vector<std::string> columns = Columns();
  std::ostringstream csv;
  for (size_t i = 0; i < columns.size(); ++i) {
    csv << (i > 0 ? "," : "") << columns[i];
  }
  csv << "\n";
  for (const ConvergenceRow& row : rows) {
    const Json json = ToJson(row);
    for (size_t i = 0; i < columns.size(); ++i) {
      csv << (i > 0 ? "," : "") << CsvValue(json, columns[i]);
    }
    csv << "\n";
  }
  return csv.str();
}

Json ConvergenceJson(const std::vector<ConvergenceRow>& rows) {
  Json json = Json::array();
  for (const ConvergenceRow& row : rows) json.push_back(ToJson(row));
  return json;
}

}  // namespace musclewarp
