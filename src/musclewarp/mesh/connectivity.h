// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// The connectivity of triangle soups, in which an edge may have any number of
// triangles and a vertex any number of fans: what the repair of a mesh has to
// work with before there is a manifold. (mesh.h has a data structure for
// manifolds.)
//
// The half-edge 3 f + c runs from corner c of triangle f to the next corner of
// that triangle. The same number also stands for corner c itself.

// Returns the half-edge that follows within the same triangle.
inline int NextHalfEdge(int half_edge) {
  return half_edge % 3 == 2 ? half_edge - 2 : half_edge + 1;
}
// Returns the point at which a half-edge starts.
inline int OriginOf(const Triangles& triangles, int half_edge) {
  return triangles(half_edge / 3, half_edge % 3);
}
// Returns the point at which a half-edge ends.
inline int TargetOf(const Triangles& triangles, int half_edge) {
  return OriginOf(triangles, NextHalfEdge(half_edge));
}

// True if triangle f names a point more than once.
inline bool HasRepeatedCorner(const Triangles& triangles, int f) {
  return triangles(f, 0) == triangles(f, 1) ||
         triangles(f, 1) == triangles(f, 2) ||
         triangles(f, 2) == triangles(f, 0);
}

// For every undirected edge, the half-edges along it in ascending order: one on
// a border, two inside a manifold, more where sheets meet. Edges are in
// ascending order of (lower point, higher point). Triangles with a repeated
// corner have no edges.
//
//   for (const EdgeUses::Uses& uses : EdgeUses(triangles)) {
//     if (uses.size() == 1) ...  // uses[0] is on a border
//   }
class EdgeUses {
 public:
  // The half-edges along one edge.
  class Uses {
   public:
    Uses(const int* begin, const int* end) : begin_(begin), end_(end) {}
    const int* begin() const { return begin_; }
    const int* end() const { return end_; }
    size_t size() const { return end_ - begin_; }
    int operator[](size_t i) const { return begin_[i]; }

   private:
    const int* begin_;
    const int* end_;
  };

  explicit EdgeUses(const Triangles& triangles);

  // The edges point to the half-edges, which a copy would have elsewhere.
  EdgeUses(const EdgeUses&) = delete;
  EdgeUses& operator=(const EdgeUses&) = delete;
  EdgeUses(EdgeUses&&) = default;
  EdgeUses& operator=(EdgeUses&&) = default;

  size_t size() const { return edges_.size(); }
  bool empty() const { return edges_.empty(); }
  const Uses& operator[](size_t edge) const { return edges_[edge]; }
  std::vector<Uses>::const_iterator begin() const { return edges_.begin(); }
  std::vector<Uses>::const_iterator end() const { return edges_.end(); }

 private:
  std::vector<int> half_edges_;  // edge by edge
  std::vector<Uses> edges_;
};

// Disjoint sets of the numbers 0 .. size - 1 (union-find), each represented by
// its lowest member, so that the outcome does not depend on the order in which
// sets are joined.
class DisjointSets {
 public:
  // Every number starts as a set of its own.
  explicit DisjointSets(int size);

  // Returns the lowest member of the set that contains i. Shortens the paths it
  // walks, hence not const.
  int Find(int i);

  // Unites the sets that contain i and j.
  void Join(int i, int j);

 private:
  std::vector<int> parent_;
};

// The connected components of a soup: label[f] (#F) is the component of
// triangle f, 0 .. count - 1, numbered in the order of their first triangles.
struct Components {
  std::vector<int> label;
  int count = 0;
};

// Finds the components. Two triangles are connected if they share an edge that
// has at most `max_uses` triangles: with 2, sheets end where three or more
// meet; with the number of triangles, they do not. `edges` is
// EdgeUses(triangles).
Components ConnectedComponents(const Triangles& triangles,
                               const EdgeUses& edges,
                               size_t max_uses);

// Removes the points that no triangle names; the others keep their order.
// Returns the number of points removed.
int DropUnreferencedPoints(TriangleSoup* soup);

// Removes the triangles f for which keep[f] (#F) is false; the others keep
// their order.
void KeepTriangles(const std::vector<bool>& keep, Triangles* triangles);

}  // namespace musclewarp
