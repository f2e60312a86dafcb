// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// What OrientConsistently has done.
struct Flips {
  // The number of triangles turned round.
  int flipped = 0;
  // The number of edges whose two triangles cannot be made consistent: the
  // surface has one side only, like a Moebius strip.
  int conflicts = 0;
  // The middle of one of these edges, mm.
  Eigen::RowVector3d conflict = {0, 0, 0};
};

// Turns triangles round so that the two triangles of every edge with exactly
// two run along it in opposite directions. Edges with more triangles separate
// components. A component that encloses a volume by itself is turned outward;
// in any other the triangles keep the side that has the larger area, so that
// the majority stays as it was.
Flips OrientConsistently(TriangleSoup* soup);

}  // namespace musclewarp
