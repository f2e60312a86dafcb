// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// `count` of the points (#V x 3), or all if there are fewer, far from each
// other: each next one is the farthest from those taken, the first is the first
// of all. Of points at the same place one is taken. In the order in which they
// are taken.
std::vector<int> SpreadPoints(const Points& points, int count);

}  // namespace musclewarp
