// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

struct Stitches {
  int merged_points = 0;    // border points that became another one
  int inserted_points = 0;  // border edges split at a border point
  double longest = 0;       // mm, how far the farthest point moved, or the
                            // farthest edge was bent to meet a point
};

// Closes cracks between borders at most `tolerance` mm wide. Border points
// are merged with border points, border edges split at border points beside
// them (T-junctions); narrow cracks go first. Only border points move, and only
// onto another border point. Nothing is done that would put a third triangle on
// an edge. Precondition: consistently oriented, at most two triangles an edge.
// Points that vanish stay as unreferenced rows.
Stitches StitchBorders(double tolerance, TriangleSoup* soup);

}  // namespace musclewarp
