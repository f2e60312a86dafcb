// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Returns a warning for each line that turns by more than 120 degrees between
// two consecutive segments in some pose, and names the pose in which it turns
// most. Lines fold back on themselves where a joint closes and the points on
// both sides of it pass each other. A muscle cannot follow such a line without
// folds.
std::vector<std::string> FoldedLineWarnings(const Scene& scene);

}  // namespace musclewarp
