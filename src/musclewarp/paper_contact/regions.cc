// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/paper_contact/regions.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "musclewarp/mesh/connectivity.h"

namespace musclewarp {

std::vector<Region> ConnectedRegions(const std::vector<int>& inside,
                                     const Points& points,
                                     const Triangles& triangles) {
  if (inside.empty()) return {};
  std::vector<int> number(points.rows(), -1);  // among those inside
  for (size_t i = 0; i < inside.size(); ++i) {
    number[inside[i]] = static_cast<int>(i);
  }
  DisjointSets sets(static_cast<int>(inside.size()));
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    for (int c = 0; c < 3; ++c) {
      const int i = number[triangles(f, c)];
      const int j = number[triangles(f, (c + 1) % 3)];
      if (i >= 0 && j >= 0) sets.Join(i, j);
    }
  }
  std::map<int, Region> by_root;
  for (size_t i = 0; i < inside.size(); ++i) {
    by_root[sets.Find(static_cast<int>(i))].vertices.push_back(inside[i]);
  }
  std::vector<Region> regions;
  for (auto& [root, region] : by_root) {
    region.centre.setZero();
    for (const int v : region.vertices) region.centre += points.row(v);
    region.centre /= static_cast<double>(region.vertices.size());
    regions.push_back(std::move(region));
  }
  return regions;
}

std::vector<std::pair<int, int>> PairRegions(const std::vector<Region>& a,
                                             const std::vector<Region>& b,
                                             double max_distance) {
  // Sorted by x, the regions of b that may be near enough are a range.
  std::vector<std::pair<double, int>> along_x;
  for (size_t j = 0; j < b.size(); ++j) {
    along_x.emplace_back(b[j].centre.x(), static_cast<int>(j));
  }
  std::sort(along_x.begin(), along_x.end());
  std::vector<std::tuple<double, int, int>> candidates;
  for (size_t i = 0; i < a.size(); ++i) {
    const double x = a[i].centre.x();
    auto near = std::lower_bound(
        along_x.begin(), along_x.end(), std::make_pair(x - max_distance, -1));
    for (; near != along_x.end() && near->first <= x + max_distance; ++near) {
      const int j = near->second;
      const double distance = (a[i].centre - b[j].centre).norm();
      if (distance <= max_distance) {
        candidates.emplace_back(distance, static_cast<int>(i), j);
      }
    }
  }
  std::sort(candidates.begin(), candidates.end());
  std::vector<bool> is_paired_a(a.size(), false);
  std::vector<bool> is_paired_b(b.size(), false);
  std::vector<std::pair<int, int>> pairs;
  for (const auto& [distance, i, j] : candidates) {
    if (is_paired_a[i] || is_paired_b[j]) continue;
    is_paired_a[i] = is_paired_b[j] = true;
    pairs.emplace_back(i, j);
  }
  return pairs;
}

}  // namespace musclewarp
