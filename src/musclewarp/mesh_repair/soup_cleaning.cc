// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_repair/soup_cleaning.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <vector>

#include "musclewarp/mesh/connectivity.h"
#include "musclewarp/mesh/defects.h"

namespace musclewarp {

PointMerges MergePoints(double tolerance, TriangleSoup* soup) {
  const Points& points = soup->points;
  const int num_points = static_cast<int>(points.rows());
  // Points to merge are close to each other in the order of their x.
  std::vector<int> by_x(num_points);
  std::iota(by_x.begin(), by_x.end(), 0);
  std::sort(by_x.begin(), by_x.end(), [&](int a, int b) {
    return points(a, 0) != points(b, 0) ? points(a, 0) < points(b, 0) : a < b;
  });
  std::vector<int> place(num_points);
  for (int i = 0; i < num_points; ++i) place[by_x[i]] = i;

  std::vector<int> target(num_points);
  PointMerges merges;
  for (int v = 0; v < num_points; ++v) {
    target[v] = v;
    for (const int step : {-1, 1}) {
      for (int i = place[v] + step; i >= 0 && i < num_points; i += step) {
        const int other = by_x[i];
        if (std::abs(points(other, 0) - points(v, 0)) > tolerance) break;
        if (other > v || target[other] != other) continue;
        if ((points.row(other) - points.row(v)).norm() > tolerance) continue;
        target[v] = std::min(target[v], other);
      }
    }
    if (target[v] == v) continue;
    ++merges.merged;
    merges.longest = std::max(merges.longest,
                              (points.row(target[v]) - points.row(v)).norm());
  }
  for (int i = 0; i < soup->triangles.size(); ++i) {
    int& corner = soup->triangles.data()[i];
    corner = target[corner];
  }
  return merges;
}

int RemoveDegenerateTriangles(TriangleSoup* soup) {
  std::vector<bool> keep(soup->triangles.rows());
  for (size_t f = 0; f < keep.size(); ++f) keep[f] = !IsDegenerate(*soup, f);
  KeepTriangles(keep, &soup->triangles);
  return static_cast<int>(std::count(keep.begin(), keep.end(), false));
}

int RemoveDuplicateTriangles(Triangles* triangles) {
  std::set<std::array<int, 3>> seen;
  std::vector<bool> keep(triangles->rows());
  for (size_t f = 0; f < keep.size(); ++f) {
    std::array<int, 3> corners = {
        (*triangles)(f, 0), (*triangles)(f, 1), (*triangles)(f, 2)};
    std::sort(corners.begin(), corners.end());
    keep[f] = seen.insert(corners).second;
  }
  KeepTriangles(keep, triangles);
  return static_cast<int>(std::count(keep.begin(), keep.end(), false));
}

}  // namespace musclewarp
