// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

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

  // What in the table was ignored or does not agree with its header.
  std::vector<std::string> warnings;
};

// Turns a table of an OpenSim motion or states file into values of the
// coordinates of a model.
//
// Columns are matched to coordinates by name ("hip_flexion_r") or by OpenSim 4
// path ("/jointset/hip_r/hip_flexion_r", or the same with "/value"). Angles in
// degrees become radians. Coordinates without a column have their default
// value, and coupled ones follow their couplers. Columns of speeds, activations
// and fibre lengths, as states files have them, are ignored. A column that is
// no coordinate of the model and is zero throughout leads to a warning.
//
// `path` names the file in messages. Throws InputError if a column that is not
// zero throughout is no coordinate of the model, if two columns are for one
// coordinate, if no column is for any, or if the header does not say whether
// angles are in degrees.
CoordinateMotion MotionOf(const Model& model,
                          const StorageTable& table,
                          const std::string& path);

}  // namespace musclewarp
