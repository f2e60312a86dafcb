// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// The first steps of a repair: removes points and triangles that are given
// twice, and triangles without area.

// What MergePoints has done.
struct PointMerges {
  // The number of points that were replaced by an earlier one.
  int merged = 0;
  // The largest distance between a point and its replacement, mm.
  double longest = 0;
};

// Replaces points in triangles by the first earlier point that was itself kept
// and is at most `tolerance` mm away (0: only equal coordinates). Points that
// were replaced stay as unreferenced rows.
PointMerges MergePoints(double tolerance, TriangleSoup* soup);

// Removes triangles with a repeated corner or an area of exactly zero, and
// returns their number. A removed triangle whose corners lie on a line leaves a
// T-junction of width zero, which StitchBorders closes.
int RemoveDegenerateTriangles(TriangleSoup* soup);

// Of triangles with the same corners in any order, keeps the first. Returns the
// number of triangles removed.
int RemoveDuplicateTriangles(Triangles* triangles);

}  // namespace musclewarp
