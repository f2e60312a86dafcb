// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// What StitchBorders has done.
struct Stitches {
  // Border points that were replaced by another border point.
  int merged_points = 0;
  // Border edges that were split at a border point beside them.
  int inserted_points = 0;
  // The largest distance that a merged point moved, or that an edge was bent to
  // meet an inserted point, mm.
  double longest = 0;
};

// Closes the cracks that run between borders of a mesh: seams along which two
// patches were triangulated independently, and T-junctions. A crack may be
// `tolerance` mm wide. Border points are merged with border points within that
// distance, and border edges are split at border points beside them; the
// narrowest cracks are closed first.
//
// Only border points move, and only onto another border point, so the surface
// away from cracks keeps its shape. A stitch that would put a third triangle on
// an edge is left out. Merged points stay as unreferenced rows. Precondition
// (CHECKed): the soup is consistently oriented with at most two triangles per
// edge.
Stitches StitchBorders(double tolerance, TriangleSoup* soup);

}  // namespace musclewarp
