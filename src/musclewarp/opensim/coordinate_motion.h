// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/opensim/kinematics.h"
#include "musclewarp/opensim/model.h"
#include "musclewarp/opensim/storage_table.h"

namespace musclewarp {

// The coordinates of a model over time.
struct CoordinateMotion {
  std::vector<double> times;             // s, rising
  std::vector<CoordinateValues> values;  // #times
  std::vector<int> given;   // coordinates the table has, in its order
  std::vector<int> moving;  // of these, those that change
  std::vector<std::string> warnings;
};

// Matches the columns of a table to the coordinates of a model: by name
// ("hip_flexion_r") or by OpenSim 4 path ("/jointset/hip_r/hip_flexion_r" or
// ".../value"). Angles in degrees become radians; coordinates without a column
// have their default; couplers are applied. Columns of speeds, activations and
// fibre lengths, as states files have them, are passed over; a column that
// nothing in the model has and that is zero throughout gets a warning. `path`
// is for messages. Throws InputError: a column the model lacks that is not
// zero, two columns for one coordinate, no column for any, inDegrees missing.
CoordinateMotion MotionOf(const Model& model,
                          const StorageTable& table,
                          const std::string& path);

}  // namespace musclewarp
