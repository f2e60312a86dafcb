// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/opensim/model.h"
#include "musclewarp/scene/json_fields.h"

namespace musclewarp {

// What the motions that a scene file describes itself have in common
// (RampedMotion, DesignedPostures): they name coordinates of a model and give
// them values, in degrees for rotational and in mm for translational ones.

// Throws InputError, which names `field` and lists the coordinates of the
// model, if one of `names` is none of them.
void CheckCoordinateNames(const JsonField& field,
                          const std::vector<std::string>& names,
                          const Model& model);

// Returns the values of a coordinate. Throws InputError if the field is not a
// list of numbers from -1e7 to 1e7 with at least one element.
std::vector<double> ReadCoordinateValues(const JsonField& field);

// Returns the number of units of a scene file in one unit of a table of
// OpenSim, which has degrees and m: 1000 for translational coordinates, or 1.
double ScenePerTableUnit(const Coordinate& coordinate);

}  // namespace musclewarp
