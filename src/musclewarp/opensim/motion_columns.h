// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/opensim/model.h"
#include "musclewarp/opensim/storage_table.h"

namespace musclewarp {

// Which columns of a table are coordinates of a model.
struct MotionColumns {
  // For each column the index of its coordinate, or -1.
  std::vector<int> coordinates;

  // The labels of columns that are left out and were not to be expected: all
  // but the speeds, activations and fibre lengths of states files.
  std::vector<std::string> others;

  // The columns whose label is the name of coordinates of several joints, by
  // index: what they are for is not known.
  std::vector<int> ambiguous;
};

// Matches the columns of a table to the coordinates of a model by name
// ("hip_flexion_r") or by path ("/jointset/hip_r/hip_flexion_r", or the same
// with "/value"). The other columns are markers, forces, and coordinates that
// this model does not have.
//
// `path` names the file in messages. Throws InputError if two columns are for
// one coordinate, or if a column that is not zero throughout is misspelt: it is
// nearly the name of a coordinate that has no column.
MotionColumns MatchColumns(const Model& model,
                           const StorageTable& table,
                           const std::string& path);

// Returns true if `name` is likely a misspelling of `coordinate`: if one letter
// in six is another one, missing or added. Names that differ only in parts such
// as r and l, tx and ty, or numbers are of different coordinates.
bool IsNearlyNamed(const std::string& name, const std::string& coordinate);

}  // namespace musclewarp
