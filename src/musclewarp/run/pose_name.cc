// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/run/pose_name.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "musclewarp/base/text.h"

namespace musclewarp {
namespace {

// "5", "-12.25": at most two digits behind the point, and no "-0".
std::string ShortNumber(double value) {
  constexpr int kDigits = 15;
  return NumberText(std::round(value * 100) / 100 + 0.0, kDigits);
}

}  // namespace

std::string UnitInReports(CoordinateKind kind) {
  return kind == CoordinateKind::kRotational      ? "degrees"
         : kind == CoordinateKind::kTranslational ? "m"
                                                  : "";
}

std::vector<MovingCoordinate> MovingCoordinatesOf(const Scene& scene) {
  std::vector<MovingCoordinate> moving;
  if (!scene.model) return moving;
  for (const int index : scene.model->moving_coordinates) {
    const Coordinate& coordinate = scene.model->model.coordinates[index];
    moving.push_back({coordinate.name, UnitInReports(coordinate.kind)});
  }
  return moving;
}

std::vector<MovingCoordinate> MovingCoordinatesIn(const JsonField& report) {
  std::vector<MovingCoordinate> moving;
  if (!report.Has("motion") || report.At("motion").value().is_null()) {
    return moving;
  }
  const JsonField coordinates = report.At("motion").At("coordinates");
  for (size_t i = 0; i < coordinates.ArraySize(); ++i) {
    const JsonField coordinate = coordinates.At(i);
    if (!coordinate.At("moves").AsBool()) continue;
    // The unit may be empty, which AsString() refuses.
    const auto& unit = coordinate.At("unit").value();
    moving.push_back({coordinate.At("name").AsString(),
                      unit.is_string() ? unit.get<std::string>() : ""});
  }
  return moving;
}

std::string PoseName(const std::string& name,
                     const std::map<std::string, double>& values,
                     const std::vector<MovingCoordinate>& moving) {
  constexpr int kMostInName = 3;
  std::string text;
  int count = 0;
  for (const MovingCoordinate& coordinate : moving) {
    const auto value = values.find(coordinate.name);
    if (value == values.end()) continue;
    text += (count++ == 0 ? "" : ", ") + coordinate.name + " " +
            ShortNumber(value->second) + (coordinate.unit.empty() ? "" : " ") +
            coordinate.unit;
  }
  return count == 0 || count > kMostInName ? name : text;
}

}  // namespace musclewarp
