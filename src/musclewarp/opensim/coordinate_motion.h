// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "musclewarp/opensim/kinematics.h"
#include "musclewarp/opensim/model.h"
#include "musclewarp/opensim/storage_table.h"

namespace musclewarp {

// The values of all coordinates of a model over time.
struct CoordinateMotion {
  std::vector<double> times;             // s, ascending
  std::vector<CoordinateValues> values;  // one entry for each time

  // The coordinates for which the table has a column, in its order, and those
  // of them whose value changes.
  std::vector<int> given;
  std::vector<int> moving;

  // The coordinates of several joints that have the name of a column, which
  // does not say whose value it is, and no column of their own: their values
  // are not known.
  std::vector<int> ambiguous;

  // What in the table was ignored or does not agree with its header.
  std::vector<std::string> warnings;
};

// Turns a table of an OpenSim motion or states file into values of the
// coordinates of a model.
//
// Columns are matched to coordinates as motion_columns.h has it; the others are
// left out, with a warning that counts and names them. Angles in degrees become
// radians: `in_degrees` tells whether angles are or, without it, the table.
// Coordinates without a column have their default value, and coupled ones
// follow their couplers.
//
// `path` names the file in messages. Throws InputError for a column that is
// nearly named as a coordinate, if two columns are for one coordinate, if one
// of a coordinate has a value that is not finite, if no column is for any, or
// if there are angles and nothing says whether they are in degrees.
CoordinateMotion MotionOf(const Model& model,
                          const StorageTable& table,
                          const std::string& path,
                          std::optional<bool> in_degrees = std::nullopt);

}  // namespace musclewarp
