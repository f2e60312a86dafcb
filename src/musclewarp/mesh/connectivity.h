// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Connectivity of triangle soups, where an edge may have any number of
// triangles. Half-edge 3 f + c runs from corner c of triangle f to the next
// corner; it stands for the corner, too.

inline int NextHalfEdge(int half_edge) {
  return half_edge % 3 == 2 ? half_edge - 2 : half_edge + 1;
}
inline int OriginOf(const Triangles& triangles, int half_edge) {
  return triangles(half_edge / 3, half_edge % 3);
}
inline int TargetOf(const Triangles& triangles, int half_edge) {
  return OriginOf(triangles, NextHalfEdge(half_edge));
}

inline bool HasRepeatedCorner(const Triangles& triangles, int f) {
  return triangles(f, 0) == triangles(f, 1) ||
         triangles(f, 1) == triangles(f, 2) ||
         triangles(f, 2) == triangles(f, 0);
}

// The half-edges between the same two points, one entry per undirected edge in
// ascending order of (lower, higher point). Triangles with a repeated corner
// have no edges.
using EdgeUses = std::vector<std::vector<int>>;
EdgeUses UsesOfEdges(const Triangles& triangles);

// Disjoint sets of 0 .. size - 1; the root of a set is its lowest member.
class DisjointSets {
 public:
  explicit DisjointSets(int size);
  int Find(int i);
  void Join(int i, int j);

 private:
  std::vector<int> parent_;
};

// #F: a label per triangle, the same for two triangles connected through edges
// with at most max_uses triangles; labels count from 0 by first triangle.
struct Components {
  std::vector<int> label;
  int count = 0;
};
Components ConnectedComponents(const Triangles& triangles,
                               const EdgeUses& edges,
                               size_t max_uses);

// The vertices without unused points, in the order they have; returns how many
// were unused.
int DropUnreferencedPoints(TriangleSoup* soup);

// Keeps the triangles f with keep[f], in their order.
void KeepTriangles(const std::vector<bool>& keep, Triangles* triangles);

}  // namespace musclewarp
