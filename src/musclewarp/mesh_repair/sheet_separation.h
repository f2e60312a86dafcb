// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Cutting a soup into 2-manifold sheets by doubling points, after Gueziec,
// Taubin, Lazarus and Horn, "Cutting and stitching: converting sets of polygons
// to manifold surfaces", IEEE TVCG 7 (2001). Copies lie on their originals; the
// widest sheet around a point keeps the original.

struct Separation {
  int edges = 0;   // edges with more than two triangles before
  int copies = 0;  // points added
};

// Pairs the triangles around every edge with more than two so that each pair
// bounds the same wedge of inside; odd ones out, first those of open flaps, end
// in a border. Precondition: consistently oriented.
Separation SeparateAtNonManifoldEdges(TriangleSoup* soup);

// Every fan of triangles around a point gets a point of its own; edges have two
// triangles at most already. Returns the number of copies.
int SeparateAtNonManifoldVertices(TriangleSoup* soup);

}  // namespace musclewarp
