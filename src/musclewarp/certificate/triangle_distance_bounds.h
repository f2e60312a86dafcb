// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <limits>

#include "musclewarp/mesh/triangle.h"

namespace musclewarp {

// Bounds between which the distance of two triangles is proved to be, mm.
struct DistanceBounds {
  double at_least = 0;
  double at_most = std::numeric_limits<double>::infinity();

  // The mid-point of the closest two points, mm, as computed.
  Eigen::RowVector3d place = Eigen::RowVector3d::Zero();
};

// Returns bounds of the distance of two triangles, which may be degenerate. The
// coordinates count exactly as they are stored, and no rounding makes a bound
// wrong. Away from overflow the bounds are usually about 1e-14 of the size of
// the triangles and of their distance apart, wherever the triangles are. They
// are the same if a and b are exchanged. Triangles that share a point have
// zero bounds.
//
// - The upper bound is the distance of a point of a and a point of b. They are
//   found in floating point, and whatever they are, no two closest points are
//   farther apart; what is added bounds the rounding of the points and of their
//   distance.
// - The lower bound is the gap between the projections of the six corners onto
//   a line. For every direction of the line it is at most the distance, so that
//   the direction need not be exact: that of the closest points, as computed,
//   or the normal of a triangle, or a normal of two edges. Only the rounding of
//   the projections is taken off.
//
// If a line shows quickly that the triangles are more than `reach` (mm) apart,
// at_least is above `reach`, and at_most is left infinite.
DistanceBounds BoundDistance(
    const Corners& a,
    const Corners& b,
    double reach = std::numeric_limits<double>::infinity());

}  // namespace musclewarp
