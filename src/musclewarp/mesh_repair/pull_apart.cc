// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_repair/pull_apart.h"

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "musclewarp/mesh/connectivity.h"
#include "musclewarp/mesh/defects.h"

namespace musclewarp {
namespace {

// For each point, true if it has the coordinates of an earlier one or is the
// middle corner of a triangle without area.
std::vector<bool> StuckPoints(const TriangleSoup& soup) {
  const Points& points = soup.points;
  std::vector<bool> is_stuck(points.rows(), false);
  std::set<std::array<double, 3>> seen;
  for (int v = 0; v < points.rows(); ++v) {
    is_stuck[v] =
        !seen.insert({points(v, 0), points(v, 1), points(v, 2)}).second;
  }
  for (int f = 0; f < soup.triangles.rows(); ++f) {
    if (!IsDegenerate(soup, f)) continue;
    int middle = 0;
    double longest = -1;
    for (int h = 3 * f; h < 3 * f + 3; ++h) {
      const int a = OriginOf(soup.triangles, h);
      const int b = TargetOf(soup.triangles, h);
      const double length = (points.row(a) - points.row(b)).norm();
      if (length <= longest) continue;
      longest = length;
      middle = TargetOf(soup.triangles, NextHalfEdge(h));
    }
    is_stuck[middle] = true;
  }
  return is_stuck;
}

}  // namespace

Pulls PullApart(TriangleSoup* soup) {
  constexpr double kShare = 1e-3;
  const std::vector<bool> is_stuck = StuckPoints(*soup);
  Points sum = Points::Zero(soup->points.rows(), 3);
  Points longest = Points::Zero(soup->points.rows(), 3);
  Eigen::VectorXd count = Eigen::VectorXd::Zero(soup->points.rows());
  for (int h = 0; h < soup->triangles.size(); ++h) {
    const int v = OriginOf(soup->triangles, h);
    const Eigen::RowVector3d edge =
        soup->points.row(TargetOf(soup->triangles, h)) - soup->points.row(v);
    sum.row(v) += edge;
    ++count[v];
    if (edge.norm() > longest.row(v).norm()) longest.row(v) = edge;
  }
  Pulls pulls;
  for (int v = 0; v < soup->points.rows(); ++v) {
    if (!is_stuck[v] || count[v] == 0) continue;
    Eigen::RowVector3d move = kShare * sum.row(v) / count[v];
    // A point that is in the middle of its neighbours moves along its longest
    // edge.
    if (move.norm() < kShare * kShare * longest.row(v).norm()) {
      move = kShare * longest.row(v);
    }
    soup->points.row(v) += move;
    ++pulls.points;
    pulls.longest = std::max(pulls.longest, move.norm());
  }
  return pulls;
}

}  // namespace musclewarp
