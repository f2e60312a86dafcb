// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/coordinate_motion.h"

#include <algorithm>
#include <cmath>

#include "musclewarp/base/input_error.h"
#include "musclewarp/opensim/osim_xml.h"

namespace musclewarp {
namespace {

bool EndsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() &&
         text.compare(text.size() - end.size(), end.size(), end) == 0;
}

// Returns true for columns of a states file that are not coordinates.
bool IsOtherState(const std::string& label) {
  for (const char* end : {"/speed",
                          "_u",
                          "/activation",
                          ".activation",
                          "/fiber_length",
                          ".fiber_length"}) {
    if (EndsWith(label, end)) return true;
  }
  return false;
}

std::string CoordinateName(std::string label) {
  constexpr char kValue[] = "/value";
  if (EndsWith(label, kValue)) label.resize(label.size() - sizeof(kValue) + 1);
  return LastName(label);
}

std::string KnownCoordinates(const Model& model) {
  std::string known;
  for (const Coordinate& coordinate : model.coordinates) {
    known += (known.empty() ? "" : ", ") + coordinate.name;
  }
  return known;
}

// Returns the coordinate of each column, -1 for columns to ignore.
std::vector<int> MatchColumns(const Model& model,
                              const StorageTable& table,
                              const std::string& path,
                              std::vector<std::string>* warnings) {
  std::vector<int> columns;
  std::string idle;
  for (size_t i = 0; i < table.labels.size(); ++i) {
    const std::string& label = table.labels[i];
    const int coordinate = model.FindCoordinate(CoordinateName(label));
    if (coordinate < 0 && !IsOtherState(label)) {
      if (!table.values.col(i).isZero(0)) {
        throw InputError(
            path + ": column \"" + label + "\"",
            "is not a coordinate of " + model.path,
            "remove it, or rename it; coordinates: " + KnownCoordinates(model));
      }
      idle += (idle.empty() ? "" : ", ") + label;
    }
    if (coordinate >= 0 &&
        std::count(columns.begin(), columns.end(), coordinate)) {
      throw InputError(path + ": column \"" + label + "\"",
                       "is the second one for the coordinate " +
                           model.coordinates[coordinate].name,
                       "remove one of the two");
    }
    columns.push_back(coordinate);
  }
  if (!idle.empty()) {
    warnings->push_back(path + ": columns that are no coordinate of " +
                        model.path + ", all zero and passed over: " + idle);
  }
  return columns;
}

}  // namespace

CoordinateMotion MotionOf(const Model& model,
                          const StorageTable& table,
                          const std::string& path) {
  CoordinateMotion motion;
  motion.times = table.times;
  motion.warnings = table.warnings;
  if (!table.in_degrees) {
    throw InputError(path,
                     "does not say whether angles are in degrees",
                     "add \"inDegrees=yes\" or \"inDegrees=no\" to the header");
  }
  const std::vector<int> columns =
      MatchColumns(model, table, path, &motion.warnings);
  motion.values.assign(table.times.size(), DefaultValues(model));
  for (size_t i = 0; i < columns.size(); ++i) {
    const int coordinate = columns[i];
    if (coordinate < 0) continue;
    const bool is_angle =
        model.coordinates[coordinate].kind == CoordinateKind::kRotational;
    const double unit = is_angle && *table.in_degrees ? M_PI / 180 : 1;
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
    throw InputError(
        path,
        "has no column that is a coordinate of " + model.path,
        "name columns after coordinates: " + KnownCoordinates(model));
  }
  for (CoordinateValues& values : motion.values) ApplyCouplers(model, &values);
  return motion;
}

}  // namespace musclewarp
