// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Cuts a soup into 2-manifold sheets by doubling points, after Gueziec, Taubin,
// Lazarus and Horn, "Cutting and stitching: converting sets of polygons to
// manifold surfaces", IEEE TVCG 7 (2001). Copies of a point lie on the original
// (PullApart moves them apart); the sheet with the most triangles around a
// point keeps the original.

// What SeparateAtNonManifoldEdges has done.
struct Separation {
  // The number of edges that had more than two triangles.
  int edges = 0;
  // The number of points added.
  int copies = 0;
};

// Separates the sheets that meet at edges with more than two triangles. The
// triangles around such an edge are paired so that each pair bounds the same
// wedge of inside; triangles that are left over, first those of flaps with a
// border, end in a border there. Precondition: the soup is consistently
// oriented.
Separation SeparateAtNonManifoldEdges(TriangleSoup* soup);

// Separates the sheets that meet in a single point: every fan of triangles
// around a point gets a point of its own. Precondition: edges have at most two
// triangles. Returns the number of points added.
int SeparateAtNonManifoldVertices(TriangleSoup* soup);

}  // namespace musclewarp
