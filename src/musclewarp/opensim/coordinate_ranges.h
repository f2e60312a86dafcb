// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "musclewarp/opensim/kinematics.h"
#include "musclewarp/opensim/model.h"

namespace musclewarp {

// Returns a sentence for each of the coordinates `given` that a motion takes
// far out of the range of the model, as one does whose angles are in another
// unit than it says: farther than the range is wide, and than half a turn or a
// metre. And for each that leaves a range to which the model clamps it: motions
// are followed as they are. `values`: of all coordinates, rad or m, one entry
// for each time; `in_degrees`: how the file has angles, if that is known;
// `path` names it.
std::vector<std::string> RangeWarnings(
    const Model& model,
    const std::vector<int>& given,
    const std::vector<CoordinateValues>& values,
    const std::string& path,
    std::optional<bool> in_degrees);

}  // namespace musclewarp
