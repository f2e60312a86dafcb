// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// What keeps a soup from being one closed, outward oriented 2-manifold, each
// kind counted on the soup as it is, points identified by index.
struct MeshDefects {
  int duplicate_points = 0;       // same coordinates as an earlier point
  int unreferenced_points = 0;    // in no triangle
  int degenerate_triangles = 0;   // repeated corner, or an area of exactly zero
  int duplicate_triangles = 0;    // same corners as an earlier one, any order
  int border_edges = 0;           // one triangle
  double border_length = 0;       // mm
  int non_manifold_edges = 0;     // three triangles or more
  int non_manifold_vertices = 0;  // the triangles around are not one fan
  int misoriented_edges = 0;   // two triangles that run the same way along it
  int components = 0;          // connected through edges
  bool is_inside_out = false;  // closed and consistent, but negative volume

  // Every edge has two triangles and every vertex one fan of them.
  bool is_closed_manifold = false;

  // Nothing to repair: one closed, outward oriented 2-manifold component with
  // all counts of defects zero.
  bool IsClean() const;
};

MeshDefects CountDefects(const TriangleSoup& soup);

// The area of triangle f is exactly zero, or two corners are the same point.
bool IsDegenerate(const TriangleSoup& soup, int f);

}  // namespace musclewarp
