// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/near_triangles.h"

#include <algorithm>

namespace musclewarp {

std::vector<bool> TrianglesWithin(
    double reach,
    const TriangleSoup& soup,
    const std::vector<const TriangleBvh*>& surfaces) {
  std::vector<double> longest(soup.points.rows(), 0);  // edge of each vertex
  for (const auto& t : soup.triangles.rowwise()) {
    for (int k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      const double length = (soup.points.row(a) - soup.points.row(b)).norm();
      longest[a] = std::max(longest[a], length);
      longest[b] = std::max(longest[b], length);
    }
  }
  // No point of a triangle is farther from a corner than its longest edge.
  std::vector<char> is_near(soup.points.rows(), 0);
#pragma omp parallel for schedule(dynamic, 256)
  for (Eigen::Index v = 0; v < soup.points.rows(); ++v) {
    for (const TriangleBvh* surface : surfaces) {
      is_near[v] |= surface->IsWithin(soup.points.row(v), reach + longest[v]);
    }
  }
  std::vector<bool> result;
  for (const auto& t : soup.triangles.rowwise()) {
    result.push_back(is_near[t[0]] || is_near[t[1]] || is_near[t[2]]);
  }
  return result;
}

}  // namespace musclewarp
