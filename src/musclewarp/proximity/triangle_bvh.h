// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "musclewarp/base/work_counts.h"
#include "musclewarp/mesh/box.h"
#include "musclewarp/mesh/triangle.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/proximity/box_octet.h"

namespace musclewarp {

// A tree of axis-aligned boxes over the triangles of a mesh (a bounding volume
// hierarchy), which finds the triangles near a point, a mesh or themselves
// without looking at all of them. The tree is built once from the rest pose;
// Refit() follows moving vertices in linear time. Queries are const and may run
// on many threads. Their results and the order of these depend on the mesh
// only.
//
//   TriangleBvh bvh(points, triangles);
//   bvh.ForEachOverlap(other, [&](int mine, int theirs) { ... });
//   const auto hit = bvh.ClosestPoint(p, /*max_distance=*/20);
class TriangleBvh {
 public:
  // The closest point of a mesh to a query point.
  struct Closest {
    int triangle = -1;  // -1 if no triangle is within max_distance
    Eigen::RowVector3d point = Eigen::RowVector3d::Zero();
    double distance = std::numeric_limits<double>::infinity();  // mm
  };

  // Builds the tree over a triangle soup (#V x 3, #F x 3), which may be empty.
  TriangleBvh(const Points& points, const Triangles& triangles);

  // Moves the vertices to new positions (#V x 3); the triangles stay the same.
  void Refit(const Points& points);

  int num_triangles() const { return static_cast<int>(corners_.size()); }
  const Corners& corners(int triangle) const { return corners_[triangle]; }

  // Returns the box around all triangles. Precondition: there are triangles.
  const Box3& box() const { return nodes_[0].box; }

  // Calls visit(a, b) for every pair of a triangle a of this tree and a
  // triangle b of `other` whose boxes overlap. Boxes that touch overlap.
  template <typename Visit>
  void ForEachOverlap(const TriangleBvh& other, const Visit& visit) const;

  // Does the same within this tree, once for every unordered pair of two
  // different triangles.
  template <typename Visit>
  void ForEachSelfOverlap(const Visit& visit) const;

  // Return the pairs that ForEachOverlap and ForEachSelfOverlap visit and for
  // which keep(a, b) is true. `keep` is called from several threads.
  template <typename Keep>
  std::vector<std::pair<int, int>> CollectOverlaps(const TriangleBvh& other,
                                                   const Keep& keep) const;
  template <typename Keep>
  std::vector<std::pair<int, int>> CollectSelfOverlaps(const Keep& keep) const;

  // Returns the pairs of a triangle of this tree and one of another for which
  // keep(f, g) is true, of those for which enter(a, b) is true of all pairs of
  // nodes that contain them. `enter` must be true of two nodes if it is true of
  // nodes within them. Both are called from several threads.
  template <typename Enter, typename Keep>
  std::vector<std::pair<int, int>> CollectPairs(const TriangleBvh& other,
                                                const Enter& enter,
                                                const Keep& keep) const;

  // Returns the pairs of two different triangles of this tree for which keep(f,
  // g) is true, with f < g, of those for which enter(a, b) is true of all pairs
  // of nodes that contain them. `enter` must be true of two nodes if it is true
  // of nodes within them. Both are called from several threads.
  template <typename Enter, typename Keep>
  std::vector<std::pair<int, int>> CollectSelfPairs(const Enter& enter,
                                                    const Keep& keep) const;

  // Calls visit(triangle) for every triangle for which enter(box) is true of
  // all boxes that contain it. `enter` must be true of a box if it is true of a
  // smaller box in it; then no triangle is missed.
  template <typename Enter, typename Visit>
  void Traverse(const Enter& enter, const Visit& visit) const;

  // Does the same with the number of a node in place of its box, for searches
  // that know more of the nodes than their boxes.
  template <typename Enter, typename Visit>
  void TraverseNodes(const Enter& enter, const Visit& visit) const;

  const Box3& node_box(int node) const { return nodes_[node].box; }

  // Returns by node the smallest box around the boxes of its triangles (#F),
  // which may be boxes of anything, such as normals.
  std::vector<Box3> BoxesOfNodes(const std::vector<Box3>& of_triangles) const;

  // Calls visit(triangle) for triangles with bound(box) <= *limit, a lower
  // bound of a quantity that is looked for, such as a distance. Of two nodes
  // the one with the smaller bound is entered first. `visit` may lower *limit,
  // so that the rest of the search is shorter.
  template <typename Bound, typename Visit>
  void TraverseNearestFirst(const Bound& bound,
                            const Visit& visit,
                            const double* limit) const;

  // Returns the point of the mesh that is closest to `point`, if it is at most
  // max_distance (mm) away. Of triangles that are equally close it takes the
  // first.
  Closest ClosestPoint(
      const Eigen::RowVector3d& point,
      double max_distance = std::numeric_limits<double>::infinity()) const;

  // Returns true if a triangle is at most `distance` (mm) away from `point`.
  bool IsWithin(const Eigen::RowVector3d& point, double distance) const;

 private:
  // Nodes are stored depth first: the first child of a node follows it.
  struct Node {
    Box3 box;
    int second;    // index of the second child
    int triangle;  // -1 for inner nodes
    bool IsLeaf() const { return triangle >= 0; }
  };
  using NodePair = std::pair<int, int>;

  // Up to eight nodes below a node, three levels at most, or triangles.
  struct WideNode {
    BoxOctet boxes;
    std::array<int, BoxOctet::kSize> nodes;     // by lane
    std::array<int, BoxOctet::kSize> children;  // wide nodes, or ~triangle
  };

  int Build(const Points& centroids, int* begin, int* end);

  // Adds the wide node of a node, and those below. Returns its index.
  int BuildWide(int node);

  template <typename BoxOfTriangle>
  void RefitNodes(const BoxOfTriangle& box_of);

  // Calls visit(triangle) for the triangles whose boxes are within the root of
  // *limit of a point, near ones first. `visit` may lower *limit.
  template <typename Visit>
  void VisitAround(const Eigen::RowVector3d& point,
                   const Visit& visit,
                   const double* limit) const;

  // Returns the two pairs that stand for `pair` after one of its nodes, the
  // larger if there is a choice, has been replaced by its children.
  static std::array<NodePair, 2> Split(const TriangleBvh& a,
                                       const TriangleBvh& b,
                                       NodePair pair);

  // Calls visit(f, g) for the pairs of triangles in two nodes, as far as
  // enter(node of a, node of b) is true.
  template <typename Enter, typename Visit>
  static void VisitPair(const TriangleBvh& a,
                        const TriangleBvh& b,
                        NodePair root,
                        const Enter& enter,
                        const Visit& visit);

  // The same as far as boxes overlap.
  template <typename Visit>
  static void VisitPair(const TriangleBvh& a,
                        const TriangleBvh& b,
                        NodePair root,
                        const Visit& visit);

  // The condition that the boxes of two nodes overlap.
  static auto OverlapOf(const TriangleBvh& a, const TriangleBvh& b) {
    return [&a, &b](int of_a, int of_b) {
      return a.nodes_[of_a].box.Overlaps(b.nodes_[of_b].box);
    };
  }

  // Returns node pairs for which `enter` is true and that together stand for
  // `roots`, enough of them to keep many threads busy.
  template <typename Enter>
  static std::vector<NodePair> Expand(const TriangleBvh& a,
                                      const TriangleBvh& b,
                                      std::vector<NodePair> roots,
                                      const Enter& enter);

  // Returns node pairs that stand for all pairs of two triangles of this tree.
  std::vector<NodePair> SelfPairs() const;

  template <typename Enter, typename Keep>
  static std::vector<std::pair<int, int>> Collect(const TriangleBvh& a,
                                                  const TriangleBvh& b,
                                                  std::vector<NodePair> roots,
                                                  const Enter& enter,
                                                  const Keep& keep);

  Triangles triangles_;
  std::vector<Corners> corners_;  // by triangle
  std::vector<Node> nodes_;
  std::vector<WideNode> wide_nodes_;
};

}  // namespace musclewarp

#include "musclewarp/proximity/triangle_bvh_queries.h"
