// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh/connectivity.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace musclewarp {

EdgeUses UsesOfEdges(const Triangles& triangles) {
  std::vector<std::tuple<int, int, int>> keys;
  keys.reserve(triangles.size());
  for (int f = 0; f < triangles.rows(); ++f) {
    if (HasRepeatedCorner(triangles, f)) continue;
    for (int h = 3 * f; h < 3 * f + 3; ++h) {
      const auto [low, high] =
          std::minmax({OriginOf(triangles, h), TargetOf(triangles, h)});
      keys.emplace_back(low, high, h);
    }
  }
  std::sort(keys.begin(), keys.end());
  EdgeUses edges;
  for (size_t i = 0; i < keys.size(); ++i) {
    const auto [low, high, h] = keys[i];
    const bool is_new = i == 0 || std::get<0>(keys[i - 1]) != low ||
                        std::get<1>(keys[i - 1]) != high;
    if (is_new) edges.emplace_back();
    edges.back().push_back(h);
  }
  return edges;
}

DisjointSets::DisjointSets(int size) : parent_(size) {
  std::iota(parent_.begin(), parent_.end(), 0);
}

int DisjointSets::Find(int i) {
  while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
  return i;
}

void DisjointSets::Join(int i, int j) {
  const auto [low, high] = std::minmax({Find(i), Find(j)});
  parent_[high] = low;
}

Components ConnectedComponents(const Triangles& triangles,
                               const EdgeUses& edges,
                               size_t max_uses) {
  const int num_triangles = static_cast<int>(triangles.rows());
  DisjointSets sets(num_triangles);
  for (const auto& uses : edges) {
    if (uses.size() > max_uses) continue;
    for (const int h : uses) sets.Join(uses[0] / 3, h / 3);
  }
  Components components;
  components.label.resize(num_triangles);
  for (int f = 0; f < num_triangles; ++f) {
    const int root = sets.Find(f);
    components.label[f] =
        root == f ? components.count++ : components.label[root];
  }
  return components;
}

int DropUnreferencedPoints(TriangleSoup* soup) {
  const int num_points = static_cast<int>(soup->points.rows());
  std::vector<int> index(num_points, -1);
  for (int i = 0; i < soup->triangles.size(); ++i) {
    index[soup->triangles.data()[i]] = 0;
  }
  int kept = 0;
  for (int v = 0; v < num_points; ++v) {
    if (index[v] < 0) continue;
    soup->points.row(kept) = soup->points.row(v);
    index[v] = kept++;
  }
  soup->points.conservativeResize(kept, 3);
  for (int i = 0; i < soup->triangles.size(); ++i) {
    int& corner = soup->triangles.data()[i];
    corner = index[corner];
  }
  return num_points - kept;
}

void KeepTriangles(const std::vector<bool>& keep, Triangles* triangles) {
  int kept = 0;
  for (int f = 0; f < triangles->rows(); ++f) {
    if (keep[f]) triangles->row(kept++) = triangles->row(f);
  }
  triangles->conservativeResize(kept, 3);
}

}  // namespace musclewarp
