// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/coordinate_ranges.h"

#include <algorithm>
#include <cmath>

#include "musclewarp/base/angles.h"
#include "musclewarp/base/text.h"

namespace musclewarp {
namespace {

// What rounding in files may add to a range, rad or m.
constexpr double kSlack = 1e-3;

bool IsAngle(const Coordinate& coordinate) {
  return coordinate.kind == CoordinateKind::kRotational;
}

// "-172 to 172": in degrees for an angle.
std::string RangeText(const Coordinate& coordinate) {
  const double unit = IsAngle(coordinate) ? kDegreesPerRadian : 1;
  return MeasureText((*coordinate.range)[0] * unit) + " to " +
         MeasureText((*coordinate.range)[1] * unit);
}

// "60 rad = 3440 degrees", "3440 degrees" or "950 m".
std::string ValueText(const Coordinate& coordinate,
                      double value,
                      bool in_degrees) {
  switch (coordinate.kind) {
    case CoordinateKind::kRotational:
      return (in_degrees ? "" : MeasureText(value) + " rad = ") +
             MeasureText(value * kDegreesPerRadian) + " degrees";
    case CoordinateKind::kTranslational:
      return MeasureText(value) + " m";
    case CoordinateKind::kCoupled:
      break;
  }
  return MeasureText(value);
}

std::string Question(const Coordinate& coordinate, bool in_degrees) {
  if (coordinate.kind == CoordinateKind::kTranslational) {
    return ": is the motion in mm?";
  }
  if (IsAngle(coordinate) && !in_degrees) {
    return ": is the motion in degrees? ({motion_in_degrees}=yes)";
  }
  return ": is the motion right?";
}

// How far a value is out of the range, 0 within it.
double Excess(const Coordinate& coordinate, double value) {
  return std::max(
      {0.0, (*coordinate.range)[0] - value, value - (*coordinate.range)[1]});
}

bool IsFar(const Coordinate& coordinate, double excess) {
  const double width = (*coordinate.range)[1] - (*coordinate.range)[0];
  return excess > std::max(width, IsAngle(coordinate) ? M_PI : 1.0);
}

}  // namespace

std::vector<std::string> RangeWarnings(
    const Model& model,
    const std::vector<int>& given,
    const std::vector<CoordinateValues>& values,
    const std::string& path,
    std::optional<bool> in_degrees) {
  std::vector<std::string> warnings;
  for (const int index : given) {
    const Coordinate& coordinate = model.coordinates[index];
    if (!coordinate.range) continue;
    double farthest = 0, excess = 0;
    for (const CoordinateValues& at_time : values) {
      if (Excess(coordinate, at_time[index]) <= excess) continue;
      farthest = at_time[index];
      excess = Excess(coordinate, farthest);
    }
    const bool is_far = IsFar(coordinate, excess);
    if (!is_far && !(coordinate.is_clamped && excess > kSlack)) continue;
    const bool degrees = in_degrees.value_or(true);
    warnings.push_back(
        path + ": " + coordinate.name + " goes to " +
        ValueText(coordinate, farthest, degrees) + ", the model has " +
        RangeText(coordinate) +
        (is_far ? Question(coordinate, degrees)
                : " and clamps it there; the motion is followed as it is"));
  }
  return warnings;
}

}  // namespace musclewarp
