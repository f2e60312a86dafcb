// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>
#include <utility>
#include <vector>

#include "musclewarp/mesh/box.h"
#include "musclewarp/mesh/triangle.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// A tree of axis-aligned boxes over the triangles of a mesh. The topology is
// built once from the rest pose; Refit() follows moving vertices in linear
// time. Queries are const and may run on many threads. What they return, and
// the order, depends on the mesh only.
//
//   TriangleBvh bvh(points, triangles);
//   bvh.ForEachOverlap(other, [&](int mine, int theirs) { ... });
//   const auto hit = bvh.ClosestPoint(p, /*max_distance=*/20);
class TriangleBvh {
 public:
  struct Closest {
    int triangle = -1;  // -1: nothing within max_distance
    Eigen::RowVector3d point = Eigen::RowVector3d::Zero();
    double distance = std::numeric_limits<double>::infinity();  // mm
  };

  TriangleBvh(const Points& points, const Triangles& triangles);

  // New positions, same triangles.
  void Refit(const Points& points);

  // Other boxes for the triangles (#F) than those around their corners, until
  // the next Refit(): to find what is near them, or on their way.
  void RefitBoxes(const std::vector<Box3>& boxes);

  int num_triangles() const { return static_cast<int>(corners_.size()); }
  const Corners& corners(int triangle) const { return corners_[triangle]; }

  // The box around everything. Precondition: there are triangles.
  const Box3& box() const { return nodes_[0].box; }

  // Calls visit(a, b) for every pair of a triangle of this tree and one of
  // `other` whose boxes overlap (touching counts).
  template <typename Visit>
  void ForEachOverlap(const TriangleBvh& other, const Visit& visit) const;

  // The same within this tree, every unordered pair of two triangles once.
  template <typename Visit>
  void ForEachSelfOverlap(const Visit& visit) const;

  // The pairs of ForEachOverlap and ForEachSelfOverlap with keep(a, b), which
  // is called from many threads.
  template <typename Keep>
  std::vector<std::pair<int, int>> CollectOverlaps(const TriangleBvh& other,
                                                   const Keep& keep) const;
  template <typename Keep>
  std::vector<std::pair<int, int>> CollectSelfOverlaps(const Keep& keep) const;

  // Calls visit(triangle) for every triangle below nodes with enter(box).
  template <typename Enter, typename Visit>
  void Traverse(const Enter& enter, const Visit& visit) const;

  // Calls visit(triangle) for triangles below nodes with bound(box) <= limit,
  // of two nodes that of the smaller bound first. `visit` may lower *limit.
  template <typename Bound, typename Visit>
  void TraverseNearestFirst(const Bound& bound,
                            const Visit& visit,
                            const double* limit) const;

  // The closest point of any triangle, at most max_distance away.
  Closest ClosestPoint(
      const Eigen::RowVector3d& point,
      double max_distance = std::numeric_limits<double>::infinity()) const;

  // Whether a triangle is at most that far away.
  bool IsWithin(const Eigen::RowVector3d& point, double distance) const;

 private:
  // Depth first: the first child of a node is the next one.
  struct Node {
    Box3 box;
    int second;    // index of the second child
    int triangle;  // -1 for inner nodes
    bool IsLeaf() const { return triangle >= 0; }
  };
  using NodePair = std::pair<int, int>;

  int Build(const Points& centroids, int* begin, int* end);

  template <typename BoxOfTriangle>
  void RefitNodes(const BoxOfTriangle& box_of);

  // Both children of one node of the pair, of the larger if there is a choice.
  static std::array<NodePair, 2> Split(const TriangleBvh& a,
                                       const TriangleBvh& b,
                                       NodePair pair);

  template <typename Visit>
  static void VisitPair(const TriangleBvh& a,
                        const TriangleBvh& b,
                        NodePair root,
                        const Visit& visit);

  // Overlapping node pairs that together stand for `roots`, enough of them to
  // keep many threads busy.
  static std::vector<NodePair> Expand(const TriangleBvh& a,
                                      const TriangleBvh& b,
                                      std::vector<NodePair> roots);

  // The pairs of nodes that stand for all pairs of two triangles of this tree.
  std::vector<NodePair> SelfPairs() const;

  template <typename Keep>
  static std::vector<std::pair<int, int>> Collect(const TriangleBvh& a,
                                                  const TriangleBvh& b,
                                                  std::vector<NodePair> roots,
                                                  const Keep& keep);

  Triangles triangles_;
  std::vector<Corners> corners_;  // by triangle
  std::vector<Node> nodes_;
};

template <typename Visit>
void TriangleBvh::ForEachOverlap(const TriangleBvh& other,
                                 const Visit& visit) const {
  if (nodes_.empty() || other.nodes_.empty()) return;
  VisitPair(*this, other, {0, 0}, visit);
}

template <typename Visit>
void TriangleBvh::ForEachSelfOverlap(const Visit& visit) const {
  for (const NodePair& pair : SelfPairs()) {
    VisitPair(*this, *this, pair, visit);
  }
}

template <typename Keep>
std::vector<std::pair<int, int>> TriangleBvh::CollectOverlaps(
    const TriangleBvh& other, const Keep& keep) const {
  if (nodes_.empty() || other.nodes_.empty()) return {};
  return Collect(*this, other, {{0, 0}}, keep);
}

template <typename Keep>
std::vector<std::pair<int, int>> TriangleBvh::CollectSelfOverlaps(
    const Keep& keep) const {
  return Collect(*this, *this, SelfPairs(), keep);
}

template <typename Enter, typename Visit>
void TriangleBvh::Traverse(const Enter& enter, const Visit& visit) const {
  // In depth first order, skipping is going to where the subtree ends: for a
  // tree of n leaves that is 2 n - 1 nodes on. A stack of second children does
  // the same and is as deep as the tree, below 64.
  std::array<int, 64> stack;
  int size = 0;
  if (!nodes_.empty()) stack[size++] = 0;
  while (size > 0) {
    const int index = stack[--size];
    const Node& node = nodes_[index];
    if (!enter(node.box)) continue;
    if (node.IsLeaf()) {
      visit(node.triangle);
    } else {
      stack[size++] = node.second;
      stack[size++] = index + 1;
    }
  }
}

template <typename Bound, typename Visit>
void TriangleBvh::TraverseNearestFirst(const Bound& bound,
                                       const Visit& visit,
                                       const double* limit) const {
  if (nodes_.empty()) return;
  std::array<std::pair<double, int>, 64> stack;  // bound, node
  int size = 0;
  stack[size++] = {bound(nodes_[0].box), 0};
  while (size > 0) {
    const auto [distance, index] = stack[--size];
    if (distance > *limit) continue;
    const Node& node = nodes_[index];
    if (node.IsLeaf()) {
      visit(node.triangle);
      continue;
    }
    std::pair<double, int> near = {bound(nodes_[index + 1].box), index + 1};
    std::pair<double, int> far = {bound(nodes_[node.second].box), node.second};
    if (far.first < near.first) std::swap(near, far);
    if (far.first <= *limit) stack[size++] = far;
    if (near.first <= *limit) stack[size++] = near;
  }
}

template <typename Visit>
void TriangleBvh::VisitPair(const TriangleBvh& a,
                            const TriangleBvh& b,
                            NodePair root,
                            const Visit& visit) {
  std::array<NodePair, 128> stack;  // at most the sum of both depths
  int size = 0;
  stack[size++] = root;
  while (size > 0) {
    const NodePair pair = stack[--size];
    const Node& node_a = a.nodes_[pair.first];
    const Node& node_b = b.nodes_[pair.second];
    if (!node_a.box.Overlaps(node_b.box)) continue;
    if (node_a.IsLeaf() && node_b.IsLeaf()) {
      visit(node_a.triangle, node_b.triangle);
      continue;
    }
    const auto [first, second] = Split(a, b, pair);
    stack[size++] = second;
    stack[size++] = first;
  }
}

template <typename Keep>
std::vector<std::pair<int, int>> TriangleBvh::Collect(
    const TriangleBvh& a,
    const TriangleBvh& b,
    std::vector<NodePair> roots,
    const Keep& keep) {
  const std::vector<NodePair> tasks = Expand(a, b, std::move(roots));
  std::vector<std::vector<std::pair<int, int>>> found(tasks.size());
#pragma omp parallel for schedule(dynamic, 16)
  for (size_t i = 0; i < tasks.size(); ++i) {
    VisitPair(a, b, tasks[i], [&](int mine, int theirs) {
      if (keep(mine, theirs)) found[i].emplace_back(mine, theirs);
    });
  }
  std::vector<std::pair<int, int>> all;
  for (const auto& part : found) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

inline std::array<TriangleBvh::NodePair, 2> TriangleBvh::Split(
    const TriangleBvh& a, const TriangleBvh& b, NodePair pair) {
  const Node& node_a = a.nodes_[pair.first];
  const Node& node_b = b.nodes_[pair.second];
  const auto extent = [](const Box3& box) {
    return box.upper[0] - box.lower[0] + box.upper[1] - box.lower[1] +
           box.upper[2] - box.lower[2];
  };
  const bool split_a =
      node_b.IsLeaf() ||
      (!node_a.IsLeaf() && extent(node_a.box) >= extent(node_b.box));
  if (split_a) {
    return {NodePair{pair.first + 1, pair.second},
            NodePair{node_a.second, pair.second}};
  }
  return {NodePair{pair.first, pair.second + 1},
          NodePair{pair.first, node_b.second}};
}

}  // namespace musclewarp
