// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Chooses points that are spread evenly over all points (#V x 3), for use as
// samples: the first point of all is taken first, and then always the one that
// is farthest from those taken so far (farthest point sampling). Of several
// points at the same place only one is taken.
//
// Returns the indices of `count` points, or of fewer if there are not so many
// different ones, in the order in which they are taken.
std::vector<int> SpreadPoints(const Points& points, int count);

}  // namespace musclewarp
