// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "musclewarp/opensim/model.h"
#include "musclewarp/scene/json_fields.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// A coordinate that a motion changes, and its unit.
struct MovingCoordinate {
  std::string name;
  std::string unit;
};

// Returns the unit of the values that a report has of a coordinate: "degrees",
// "m", or "" for a coupled one.
std::string UnitInReports(CoordinateKind kind);

// Return the coordinates that a motion changes: that of a scene, and that of a
// report.json, for which InputError is thrown if the report is damaged. None
// without a model.
std::vector<MovingCoordinate> MovingCoordinatesOf(const Scene& scene);
std::vector<MovingCoordinate> MovingCoordinatesIn(const JsonField& report);

// Returns what a pose is called for readers, as on the page
// (tools/report/src/data/timeline.ts): "hip_flexion_r 5 degrees" where one to
// three coordinates move, or else `name`. `values` are in the units of
// `moving`; coordinates without a value are left out.
std::string PoseName(const std::string& name,
                     const std::map<std::string, double>& values,
                     const std::vector<MovingCoordinate>& moving);

}  // namespace musclewarp
