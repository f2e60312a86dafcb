// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Warnings about lines that turn back on themselves in a pose, as they do where
// a joint closes and the points on both sides of it pass each other: one
// sentence for each line that turns by more than 120 degrees from a segment to
// the next, with the pose in which it turns most. A muscle cannot follow such a
// line without folds.
std::vector<std::string> FoldedLineWarnings(const Scene& scene);

}  // namespace musclewarp
