// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// First aid for soups: points and triangles that say the same twice or nothing.

struct PointMerges {
  int merged = 0;
  double longest = 0;  // mm, how far the farthest point moved
};

// Points at most `tolerance` mm from an earlier point that was kept become that
// point (0: equal coordinates only). Merged points stay as unreferenced rows.
PointMerges MergePoints(double tolerance, TriangleSoup* soup);

// Triangles with a repeated corner or no area. Removing a sliver of no area
// leaves a T-junction of width zero, which stitching closes.
int RemoveDegenerateTriangles(TriangleSoup* soup);

// Of triangles with the same corners in any order, the first stays.
int RemoveDuplicateTriangles(Triangles* triangles);

}  // namespace musclewarp
