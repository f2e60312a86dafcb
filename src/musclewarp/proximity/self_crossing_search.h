// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "musclewarp/mesh/box.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/proximity/vertex_stars.h"

namespace musclewarp {

// Finds where a mesh that moves crosses itself. Nearly all pairs of triangles
// whose boxes overlap are neighbours, which a tree of triangles visits one by
// one. Here triangles are in groups of eight, of which 64 pairs are compared at
// once and the neighbours among them are known from the start. Neighbours are
// settled by the stars of vertices (vertex_stars.h).
//
//   const SelfCrossingSearch search(rest, triangles);
//   const auto pairs = search.Find(points);
class SelfCrossingSearch {
 public:
  using PairList = std::vector<std::pair<int, int>>;

  // Groups the triangles by where they are at `rest`, #V x 3, mm.
  SelfCrossingSearch(const Points& rest, const Triangles& triangles);

  // Returns the pairs (f, g) of triangles at which the mesh crosses itself with
  // its vertices at `points` (#V x 3, mm), with f < g and in ascending order:
  // the same as SelfIntersections() returns.
  PairList Find(const Points& points) const;

 private:
  static constexpr int kGroup = 8;
  using PairMask = std::uint64_t;  // bit 8 i + j: triangles i and j of a group

  // The boxes of the triangles of a group, by coordinate. Those of triangles
  // that are not there are empty.
  struct GroupBoxes {
    double lower[3][kGroup], upper[3][kGroup];
  };

  // Nodes are stored depth first: the first child of a node follows it.
  struct Node {
    int second = -1;  // index of the second child
    int group = -1;   // -1 for inner nodes
  };

  // A group, and its pairs of triangles with those of another that share a
  // vertex.
  struct Neighbour {
    int group;
    PairMask pairs;
  };

  // The boxes of all groups and nodes.
  struct Boxes {
    std::vector<GroupBoxes> groups;
    std::vector<Box3> nodes;
  };

  int Build(const Points& centroids, int* begin, int* end);
  void FindNeighbours();
  Boxes BoxesAt(const Points& points) const;

  // Returns the pairs of triangles of two groups whose boxes overlap, but for
  // those that share a vertex.
  PairMask PairsToTest(int a,
                       int b,
                       const std::vector<GroupBoxes>& boxes) const;
  template <typename Visit>
  void VisitPairs(int a,
                  int b,
                  const std::vector<Box3>& node_boxes,
                  const Visit& visit) const;

  // Add the pairs that cross: one, those of two groups, and those around a
  // vertex whose star is not proper.
  void AddIfCrossing(const Points& points, int f, int g, PairList* found) const;
  void TestGroups(const Points& points,
                  const Boxes& boxes,
                  int a,
                  int b,
                  PairList* found) const;
  void TestStar(const Points& points,
                const std::vector<char>& is_proper,
                int v,
                PairList* found) const;

  Triangles triangles_;
  VertexRings rings_;

  // The triangles of group g are the kGroup entries from kGroup * g on; -1 for
  // those that are not there.
  std::vector<int> members_;
  std::vector<Node> nodes_;

  // By group: those that it has vertices in common with, itself included, from
  // it on.
  std::vector<std::vector<Neighbour>> neighbours_;

  // The triangles around vertex v are the entries from first_[v] on.
  std::vector<int> first_, around_;
};

}  // namespace musclewarp
