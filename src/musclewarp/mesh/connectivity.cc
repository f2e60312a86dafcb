// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh/connectivity.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace musclewarp {

EdgeUses::EdgeUses(const Triangles& triangles) {
  const int num_triangles = static_cast<int>(triangles.rows());
  const int num_points = num_triangles > 0 ? triangles.maxCoeff() + 1 : 0;
  const auto for_each_half_edge = [&](const auto& visit) {
    for (int f = 0; f < num_triangles; ++f) {
      if (HasRepeatedCorner(triangles, f)) continue;
      for (int h = 3 * f; h < 3 * f + 3; ++h) {
        const auto [low, high] =
            std::minmax({OriginOf(triangles, h), TargetOf(triangles, h)});
        visit(low, high, h);
      }
    }
  };
  // Few half-edges have the same lower point: they are grouped by that first.
  std::vector<int> first(num_points + 1, 0);
  for_each_half_edge([&](int low, int, int) { ++first[low + 1]; });
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::pair<int, int>> keys(first.back());  // higher point, h
  std::vector<int> next = first;
  for_each_half_edge([&](int low, int high, int h) {
    keys[next[low]++] = {high, h};
  });
  half_edges_.reserve(keys.size());
  edges_.reserve(keys.size() / 2);
  for (int low = 0; low < num_points; ++low) {
    std::sort(keys.begin() + first[low], keys.begin() + first[low + 1]);
    for (int i = first[low], end = i; i < first[low + 1]; i = end) {
      const int* const begin = half_edges_.data() + half_edges_.size();
      for (; end < first[low + 1] && keys[end].first == keys[i].first; ++end) {
        half_edges_.push_back(keys[end].second);
      }
      edges_.emplace_back(begin, begin + (end - i));
    }
  }
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
