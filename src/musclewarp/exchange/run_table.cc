// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/run_table.h"

#include <algorithm>
#include <map>

#include "musclewarp/base/csv_field.h"
#include "musclewarp/base/text.h"
#include "musclewarp/mesh/long_axis.h"
#include "musclewarp/mesh/plane_section.h"
#include "musclewarp/skeleton/planes_across.h"
#include "musclewarp/skeleton/polyline.h"

namespace musclewarp {
namespace {

using Fields = std::vector<std::string>;

// As many digits as the figures mean, and no noise of rounding behind them.
std::string TableNumber(double value) { return NumberText(value, 9); }

void AppendRow(const Fields& fields, std::string* text) {
  for (size_t i = 0; i < fields.size(); ++i) {
    *text += (i == 0 ? "" : ",") + fields[i];
  }
  *text += "\n";
}

// Of a rotation the arm is a length (mm per rad).
std::string ArmColumn(const TableCoordinate& coordinate) {
  return SpreadsheetField("moment_arm_" + coordinate.name + "_mm" +
                          (coordinate.unit == "m" ? "_per_m" : ""));
}

Fields Header(const std::vector<TableCoordinate>& coordinates) {
  Fields fields = {"frame", "name", "time_s"};
  for (const TableCoordinate& coordinate : coordinates) {
    fields.push_back(SpreadsheetField(
        coordinate.name +
        (coordinate.unit.empty() ? "" : "_" + coordinate.unit)));
  }
  for (const char* name : {"muscle", "line", "length_mm"}) {
    fields.push_back(name);
  }
  for (const TableCoordinate& coordinate : coordinates) {
    if (coordinate.moves) fields.push_back(ArmColumn(coordinate));
  }
  fields.push_back("volume_mm3");
  fields.push_back("largest_section_area_mm2");
  return fields;
}

// Returns the value of a key, or an empty field.
std::string FieldOf(const std::map<std::string, double>& values,
                    const std::string& key) {
  const auto found = values.find(key);
  return found == values.end() ? "" : TableNumber(found->second);
}

class TableRows {
 public:
  TableRows(const RunOutline& run,
            const std::vector<TableCoordinate>& coordinates,
            std::string* text)
      : run_(run), coordinates_(coordinates), text_(*text) {}

  void Add(const FrameFigures& frame, const RecordedPose& pose) {
    Fields first = {std::to_string(frame.index),
                    SpreadsheetField(frame.name),
                    run_.has_times ? TableNumber(frame.time) : ""};
    for (const TableCoordinate& coordinate : coordinates_) {
      first.push_back(FieldOf(frame.coordinates, coordinate.name));
    }
    for (size_t m = 0; m < frame.muscles.size(); ++m) {
      const MuscleFigures& muscle = frame.muscles[m];
      const Fields last = {TableNumber(muscle.volume),
                           TableNumber(LargestSectionOfMuscle(
                               pose.muscles[m], pose.lines[m].lines))};
      if (muscle.line_lengths.empty()) {
        AddRow(first, muscle, "", {}, last);
      }
      for (const auto& [line, length] : muscle.line_lengths) {
        const auto arms = muscle.line_moment_arms.find(line);
        const bool are_known = frame.moment_arms_converged &&
                               arms != muscle.line_moment_arms.end();
        AddRow(first,
               muscle,
               line,
               are_known ? arms->second : std::map<std::string, double>(),
               last);
      }
    }
  }

 private:
  void AddRow(Fields row,
              const MuscleFigures& muscle,
              const std::string& line,
              const std::map<std::string, double>& arms,
              const Fields& last) {
    row.push_back(SpreadsheetField(muscle.name));
    row.push_back(SpreadsheetField(line));
    row.push_back(FieldOf(muscle.line_lengths, line));
    for (const TableCoordinate& coordinate : coordinates_) {
      if (coordinate.moves) row.push_back(FieldOf(arms, coordinate.name));
    }
    row.insert(row.end(), last.begin(), last.end());
    AppendRow(row, &text_);
  }

  const RunOutline& run_;
  const std::vector<TableCoordinate>& coordinates_;
  std::string& text_;
};

}  // namespace

std::vector<TableCoordinate> TableCoordinatesOf(const JsonField& report) {
  std::vector<TableCoordinate> coordinates;
  const JsonField motion = report.At("motion");
  if (motion.IsNull()) return coordinates;
  const JsonField list = motion.At("coordinates");
  for (size_t i = 0; i < list.ArraySize(); ++i) {
    const JsonField entry = list.At(i);
    TableCoordinate& coordinate = coordinates.emplace_back();
    coordinate.name = entry.At("name").AsString();
    // Empty texts are none to AsString().
    const JsonField unit = entry.At("unit");
    coordinate.unit = unit.AsText() == "\"\"" ? "" : unit.AsString();
    coordinate.moves = entry.At("moves").AsBool();
  }
  return coordinates;
}

std::string RunTableText(const RunOutline& run,
                         const std::vector<TableCoordinate>& coordinates,
                         const std::vector<int>& frames,
                         const std::function<void(int frame)>& on_frame) {
  const RecordedNames muscles_only = {run.names.muscles, {}};
  const RecordedPose rest = ReadRestPose(run.rest, muscles_only);
  std::string text;
  AppendRow(Header(coordinates), &text);
  TableRows rows(run, coordinates, &text);
  for (const int i : frames) {
    on_frame(i);
    const RecordedFrame& frame = run.frames[i];
    rows.Add(frame.figures, ReadPose(frame.folder, muscles_only, rest));
  }
  return text;
}

double LargestSectionOfMuscle(const TriangleSoup& muscle,
                              const std::vector<NamedLine>& lines) {
  constexpr int kPlanes = 100;
  constexpr int kPoints = 50;
  Points mean = Points::Zero(kPoints, 3);
  for (const NamedLine& line : lines) {
    mean += Resampled(line.points, kPoints) / static_cast<double>(lines.size());
  }
  const Points along = PolylineLength(mean) > 0
                           ? mean
                           : LongAxis(muscle.points, muscle.triangles);
  return LargestSectionArea(
      muscle.points, muscle.triangles, PlanesAcross(along, kPlanes));
}

}  // namespace musclewarp
