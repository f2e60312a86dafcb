// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/sharp_points.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "musclewarp/base/angles.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

double AngleDeg(const RowVector3d& u, const RowVector3d& v) {
  return DegreesOf(std::atan2(u.cross(v).norm(), u.dot(v)));
}

RowVector3d NormalOf(const Points& p, const Triangles& triangles, int f) {
  const RowVector3d a = p.row(triangles(f, 0));
  return (p.row(triangles(f, 1)) - a)
      .cross(RowVector3d(p.row(triangles(f, 2)) - a))
      .normalized();
}

}  // namespace

std::vector<bool> SharpPoints(const TriangleSoup& surface) {
  const Points& p = surface.points;
  std::vector<bool> is_sharp(p.rows(), false);
  // The first triangle of each edge, and its corner beside the edge.
  std::map<std::pair<int, int>, std::pair<int, int>> first;
  for (int f = 0; f < surface.triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const int a = surface.triangles(f, k);
      const int b = surface.triangles(f, (k + 1) % 3);
      const int c = surface.triangles(f, (k + 2) % 3);
      if (AngleDeg(p.row(b) - p.row(a), p.row(c) - p.row(a)) <
          kSharpTriangleDeg) {
        is_sharp[a] = is_sharp[b] = is_sharp[c] = true;
      }
      const auto [entry, is_new] =
          first.emplace(std::minmax(a, b), std::make_pair(f, c));
      if (is_new) continue;
      const auto [other, beside] = entry->second;
      const RowVector3d normal = NormalOf(p, surface.triangles, other);
      const bool is_reflex = (p.row(c) - p.row(a)).dot(normal) > 0;
      const double between =
          180 - AngleDeg(normal, NormalOf(p, surface.triangles, f));
      if (!is_reflex && between < kSharpEdgeDeg) {
        is_sharp[a] = is_sharp[b] = is_sharp[c] = is_sharp[beside] = true;
      }
    }
  }
  return is_sharp;
}

}  // namespace musclewarp
