// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <limits>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// A tree of axis-aligned boxes over the triangles of a mesh. The topology is
// built once from the rest pose; Refit() follows moving vertices in linear
// time. Queries are const and may run on many threads.
//
//   TriangleBvh bvh(points, triangles);
//   bvh.ForEachOverlap(other, [&](int mine, int theirs) { ... });
//   const auto hit = bvh.ClosestPoint(p, /*max_distance=*/20);
class TriangleBvh {
 public:
  struct Closest {
    int triangle = -1;  // -1: nothing within max_distance
    Eigen::RowVector3d point;
    double distance = std::numeric_limits<double>::infinity();  // mm
  };

  TriangleBvh(const Points& points, const Triangles& triangles);

  // New positions, same triangles.
  void Refit(const Points& points);

  // Calls visit(a, b) for every pair of a triangle of this tree and one of
  // `other` whose boxes overlap (touching counts). The order is deterministic.
  void ForEachOverlap(const TriangleBvh& other,
                      const std::function<void(int, int)>& visit) const;

  // The same within this tree, every unordered pair of two triangles once.
  void ForEachSelfOverlap(const std::function<void(int, int)>& visit) const;

  Closest ClosestPoint(
      const Eigen::RowVector3d& point,
      double max_distance = std::numeric_limits<double>::infinity()) const;
};

}  // namespace musclewarp
