// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The definitions of the templates of TriangleBvh, which includes this file.

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "musclewarp/base/work_counts.h"
#include "musclewarp/proximity/triangle_bvh.h"

namespace musclewarp {

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
  return Collect(*this, other, {{0, 0}}, OverlapOf(*this, other), keep);
}

template <typename Keep>
std::vector<std::pair<int, int>> TriangleBvh::CollectSelfOverlaps(
    const Keep& keep) const {
  return Collect(*this, *this, SelfPairs(), OverlapOf(*this, *this), keep);
}

template <typename Enter, typename Keep>
std::vector<std::pair<int, int>> TriangleBvh::CollectPairs(
    const TriangleBvh& other, const Enter& enter, const Keep& keep) const {
  return Collect(*this, other, {{0, 0}}, enter, keep);
}

template <typename Enter, typename Visit>
void TriangleBvh::Traverse(const Enter& enter, const Visit& visit) const {
  TraverseNodes([&](int node) { return enter(nodes_[node].box); }, visit);
}

template <typename Enter, typename Visit>
void TriangleBvh::TraverseNodes(const Enter& enter, const Visit& visit) const {
  // The stack holds at most one node per level, and the tree is less than 64
  // levels deep.
  std::array<int, 64> stack;
  int size = 0;
  if (!nodes_.empty()) stack[size++] = 0;
  while (size > 0) {
    const int index = stack[--size];
    if (!enter(index)) continue;
    const Node& node = nodes_[index];
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
  VisitPair(a, b, root, OverlapOf(a, b), visit);
}

template <typename Enter, typename Keep>
std::vector<std::pair<int, int>> TriangleBvh::CollectSelfPairs(
    const Enter& enter, const Keep& keep) const {
  const std::vector<NodePair> roots = SelfPairs();
  std::vector<std::pair<int, int>> all;
#pragma omp parallel
  {
    std::vector<std::pair<int, int>> found;
    std::int64_t visited = 0;
#pragma omp for schedule(dynamic, 64) nowait
    for (size_t i = 0; i < roots.size(); ++i) {
      VisitPair(*this, *this, roots[i], enter, [&](int a, int b) {
        ++visited;
        const auto [f, g] = std::minmax(a, b);
        if (keep(f, g)) found.emplace_back(f, g);
      });
    }
    CountWork(WorkUnit::kPairsVisited, visited);
#pragma omp critical
    all.insert(all.end(), found.begin(), found.end());
  }
  std::sort(all.begin(), all.end());
  return all;
}

template <typename Enter, typename Visit>
void TriangleBvh::VisitPair(const TriangleBvh& a,
                            const TriangleBvh& b,
                            NodePair root,
                            const Enter& enter,
                            const Visit& visit) {
  std::array<NodePair, 128> stack;  // at most the sum of both depths
  int size = 0;
  stack[size++] = root;
  while (size > 0) {
    const NodePair pair = stack[--size];
    if (!enter(pair.first, pair.second)) continue;
    const Node& node_a = a.nodes_[pair.first];
    const Node& node_b = b.nodes_[pair.second];
    if (node_a.IsLeaf() && node_b.IsLeaf()) {
      visit(node_a.triangle, node_b.triangle);
      continue;
    }
    const auto [first, second] = Split(a, b, pair);
    stack[size++] = second;
    stack[size++] = first;
  }
}

template <typename Enter>
std::vector<TriangleBvh::NodePair> TriangleBvh::Expand(
    const TriangleBvh& a,
    const TriangleBvh& b,
    std::vector<NodePair> roots,
    const Enter& enter) {
  constexpr size_t kEnough = 256;
  const auto is_leaf_pair = [&](const NodePair& pair) {
    return a.nodes_[pair.first].IsLeaf() && b.nodes_[pair.second].IsLeaf();
  };
  bool has_changed = true;
  while (has_changed && roots.size() < kEnough) {
    has_changed = false;
    std::vector<NodePair> finer;
    for (const NodePair& pair : roots) {
      if (!enter(pair.first, pair.second)) continue;
      if (is_leaf_pair(pair)) {
        finer.push_back(pair);
        continue;
      }
      for (const NodePair& half : Split(a, b, pair)) finer.push_back(half);
      has_changed = true;
    }
    roots = std::move(finer);
  }
  return roots;
}

template <typename Enter, typename Keep>
std::vector<std::pair<int, int>> TriangleBvh::Collect(
    const TriangleBvh& a,
    const TriangleBvh& b,
    std::vector<NodePair> roots,
    const Enter& enter,
    const Keep& keep) {
  if (a.nodes_.empty() || b.nodes_.empty()) return {};
  const std::vector<NodePair> tasks = Expand(a, b, std::move(roots), enter);
  std::vector<std::vector<std::pair<int, int>>> found(tasks.size());
#pragma omp parallel for schedule(dynamic, 16)
  for (size_t i = 0; i < tasks.size(); ++i) {
    int visited = 0;
    VisitPair(a, b, tasks[i], enter, [&](int mine, int theirs) {
      ++visited;
      if (keep(mine, theirs)) found[i].emplace_back(mine, theirs);
    });
    CountWork(WorkUnit::kPairsVisited, visited);
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
