// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/coordinate_motion.h"

#include <algorithm>
#include <cmath>

#include "musclewarp/base/angles.h"
#include "musclewarp/base/input_error.h"
#include "musclewarp/base/short_list.h"
#include "musclewarp/opensim/coordinate_ranges.h"
#include "musclewarp/opensim/motion_columns.h"

namespace musclewarp {
namespace {

std::string KnownCoordinates(const Model& model) {
  std::string known;
  for (const Coordinate& coordinate : model.coordinates) {
    known += (known.empty() ? "" : ", ") + coordinate.name;
  }
  return known;
}

// A sentence about the columns that are left out.
std::string LeftOut(const std::vector<std::string>& labels,
                    const Model& model,
                    const std::string& path) {
  const bool is_one = labels.size() == 1;
  return path + ": " + std::to_string(labels.size()) +
         (is_one ? " column that is no coordinate of "
                 : " columns that are no coordinates of ") +
         model.path + (is_one ? " is" : " are") +
         " left out: " + ShortList(labels);
}

void CheckFinite(const StorageTable& table,
                 size_t column,
                 const std::string& path) {
  for (size_t row = 0; row < table.times.size(); ++row) {
    if (std::isfinite(table.values(row, column))) continue;
    throw InputError(
        path + (table.lines.empty()
                    ? ": row " + std::to_string(row)
                    : ": line " + std::to_string(table.lines[row])),
        "column \"" + table.labels[column] +
            "\" has a value that is not finite",
        "every value of a coordinate must be a finite number");
  }
}

// The factor from the values of a table to those of a coordinate.
double UnitOf(const Coordinate& coordinate,
              std::optional<bool> in_degrees,
              const std::string& path) {
  if (coordinate.kind != CoordinateKind::kRotational) return 1;
  if (!in_degrees) {
    throw InputError(path,
                     "does not say whether angles are in degrees",
                     "give {motion_in_degrees}=yes or no, set "
                     "\"motion_in_degrees\" in the scene, or add "
                     "\"inDegrees=yes\" or \"inDegrees=no\" to the header");
  }
  return *in_degrees ? kRadiansPerDegree : 1;
}

}  // namespace

CoordinateMotion MotionOf(const Model& model,
                          const StorageTable& table,
                          const std::string& path,
                          std::optional<bool> in_degrees) {
  CoordinateMotion motion;
  motion.times = table.times;
  motion.warnings = table.warnings;
  if (in_degrees && table.in_degrees && *in_degrees != *table.in_degrees) {
    motion.warnings.push_back(
        path + ": angles are taken to be in " +
        (*in_degrees ? "degrees" : "radians") +
        ", as was asked for, although the header says otherwise");
  }
  if (!in_degrees) in_degrees = table.in_degrees;
  const MotionColumns columns = MatchColumns(model, table, path);
  if (!columns.others.empty()) {
    motion.warnings.push_back(LeftOut(columns.others, model, path));
  }
  for (const int column : columns.ambiguous) {
    const std::string& label = table.labels[column];
    motion.warnings.push_back(path + ": column \"" + label + "\" " +
                              WhyNoCoordinate(model, label) +
                              "; it is left out");
    for (const std::string& name : model.CoordinatesCalled(label)) {
      const int coordinate = model.FindCoordinate(name);
      const auto& known = columns.coordinates;
      if (std::count(known.begin(), known.end(), coordinate) == 0) {
        motion.ambiguous.push_back(coordinate);
      }
    }
  }
  motion.values.assign(table.times.size(), DefaultValues(model));
  for (size_t i = 0; i < columns.coordinates.size(); ++i) {
    const int coordinate = columns.coordinates[i];
    if (coordinate < 0) continue;
    CheckFinite(table, i, path);
    const double unit = UnitOf(model.coordinates[coordinate], in_degrees, path);
    motion.given.push_back(coordinate);
    const auto column = table.values.col(i);
    if ((column.array() != column[0]).any()) {
      motion.moving.push_back(coordinate);
    }
    for (size_t row = 0; row < table.times.size(); ++row) {
      motion.values[row][coordinate] = unit * column[row];
    }
  }
  if (motion.given.empty()) {
    constexpr size_t kMostNamed = 5;
    throw InputError(
        path,
        "has no column that is a coordinate of " + model.path + ", but " +
            ShortList(table.labels, kMostNamed),
        "name columns after coordinates: " + KnownCoordinates(model));
  }
  const std::vector<std::string> beyond =
      RangeWarnings(model, motion.given, motion.values, path, in_degrees);
  motion.warnings.insert(motion.warnings.end(), beyond.begin(), beyond.end());
  for (CoordinateValues& values : motion.values) ApplyCouplers(model, &values);
  return motion;
}

}  // namespace musclewarp
