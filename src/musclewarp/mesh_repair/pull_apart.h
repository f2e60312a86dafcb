// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

struct Pulls {
  int points = 0;
  double longest = 0;  // mm
};

// Moves points that have the coordinates of an earlier one, and the middle
// corner of triangles of no area, a thousandth of the way to the mean of their
// neighbours or, if they are there, along their longest edge: sheets that were
// cut apart then stay apart in files that know points by their coordinates, and
// every triangle has a normal.
Pulls PullApart(TriangleSoup* soup);

}  // namespace musclewarp
