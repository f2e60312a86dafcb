// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// What PullApart has done.
struct Pulls {
  // The number of points that were moved.
  int points = 0;
  // The longest move, mm.
  double longest = 0;
};

// Moves apart what lies on one another after sheets were cut apart: points with
// the coordinates of an earlier point, and the middle corner of triangles
// without area. Sheets then stay apart in file formats that identify points by
// their coordinates (STL), and every triangle has a normal.
//
// A point moves a thousandth of the way to the mean of its neighbours, or along
// its longest edge if it is at that mean already. A moved point may land on
// another; callers repeat until nothing moves.
Pulls PullApart(TriangleSoup* soup);

}  // namespace musclewarp
