// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "musclewarp/mesh/triangle.h"

namespace musclewarp {

// Returns the point of a triangle that is closest to `p`. Any triangle will do,
// degenerate ones too.
Eigen::RowVector3d ClosestPointOfTriangle(const Eigen::RowVector3d& p,
                                          const Corners& triangle);

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
