// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "musclewarp/geometry/triangle_bvh.h"

namespace musclewarp {

// The two points of two triangles that are closest to each other.
struct ClosestPair {
  Eigen::RowVector3d on_a = Eigen::RowVector3d::Zero();
  Eigen::RowVector3d on_b = Eigen::RowVector3d::Zero();
  double squared_distance = 0;  // mm^2
};

// Any two triangles that do not cross, degenerate ones too. Of two that cross,
// the closest pair of their borders.
ClosestPair ClosestPointsOfTriangles(const Corners& a, const Corners& b);

}  // namespace musclewarp
