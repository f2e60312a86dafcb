// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Why a mesh is not usable as it is. The deformation needs one closed, outward
// oriented 2-manifold per muscle and bone; the counts below say what separates
// a soup from that. Each kind of defect is counted on the soup as it stands,
// before any repair, and points are the same only if their indices are. One
// fault may be counted as several kinds: a doubled triangle also makes three
// non-manifold edges.
struct MeshDefects {
  // Points with exactly the coordinates of an earlier point.
  int duplicate_points = 0;
  // Points that no triangle names.
  int unreferenced_points = 0;
  // Triangles with a repeated corner or an area of exactly zero.
  int degenerate_triangles = 0;
  // Triangles with the same corners as an earlier one, in any order.
  int duplicate_triangles = 0;
  // Edges with a single triangle, and their total length in mm.
  int border_edges = 0;
  double border_length = 0;
  // Edges with three triangles or more.
  int non_manifold_edges = 0;
  // Points whose triangles form more than one fan, for example where two bodies
  // touch in a point.
  int non_manifold_vertices = 0;
  // Edges with two triangles that run along them in the same direction, so that
  // one faces outward and the other inward.
  int misoriented_edges = 0;
  // Pieces that are connected through edges.
  int components = 0;
  // The surface is closed and consistently oriented, but its volume is
  // negative: all triangles face inward.
  bool is_inside_out = false;

  // True if every edge has two triangles and every vertex one fan of them,
  // whatever their orientation.
  bool is_closed_manifold = false;

  // True if nothing needs repair: the soup is one closed, outward oriented
  // 2-manifold component, and all counts of defects are zero.
  bool IsClean() const;

  // The same of any number of components, one at least. That every one of them
  // faces outward is not looked at.
  bool IsCleanInPieces() const;
};

// Counts the defects of a soup. A soup without triangles is not clean.
MeshDefects CountDefects(const TriangleSoup& soup);

// True if the area of triangle f is exactly zero or two of its corners are the
// same point.
bool IsDegenerate(const TriangleSoup& soup, int f);

}  // namespace musclewarp
