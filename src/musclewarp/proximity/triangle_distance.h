// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "musclewarp/mesh/triangle.h"

namespace musclewarp {

// Returns the point of a triangle that is closest to `p`. The triangle may be
// degenerate, that is, a segment or a point.
Eigen::RowVector3d ClosestPointOfTriangle(const Eigen::RowVector3d& p,
                                          const Corners& triangle);

// A point of triangle a and a point of triangle b that are as close to each
// other as any two points of these triangles.
struct ClosestPair {
  Eigen::RowVector3d on_a = Eigen::RowVector3d::Zero();
  Eigen::RowVector3d on_b = Eigen::RowVector3d::Zero();
  double squared_distance = 0;  // mm^2
};

// Returns the closest points of two triangles, which may be degenerate. The
// plane half way between them, orthogonal to the line from one to the other,
// separates the triangles. If the triangles cross, the result is the closest
// pair of points on their borders, and its distance need not be zero.
ClosestPair ClosestPointsOfTriangles(const Corners& a, const Corners& b);

}  // namespace musclewarp
