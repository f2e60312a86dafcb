// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

struct Flips {
  int flipped = 0;    // triangles turned
  int conflicts = 0;  // edges that no choice makes consistent (one-sided)
  Eigen::RowVector3d conflict = {0, 0, 0};  // middle of such an edge
};

// Turns triangles so that the two of every edge with exactly two run opposite
// ways along it. Within a component the side with the larger area wins, but one
// that encloses a volume by itself is turned outward.
Flips OrientConsistently(TriangleSoup* soup);

}  // namespace musclewarp
