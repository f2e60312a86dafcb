// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// The corners of a triangle by position instead of index, one per row, mm: what
// geometric predicates and distances work on.
using Corners = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

// Returns the corners of a triangle of a mesh, given as a row of Triangles.
inline Corners CornersOf(const Points& points,
                         const Eigen::RowVector3i& triangle) {
  Corners corners;
  for (int k = 0; k < 3; ++k) corners.row(k) = points.row(triangle[k]);
  return corners;
}

// Returns the normal of a triangle by the right-hand rule, outward for the
// triangles of an outward oriented mesh. Its length is twice the area, mm^2, so
// that a triangle without area has the zero vector.
inline Eigen::RowVector3d AreaVector(const Corners& t) {
  return Eigen::RowVector3d(t.row(1) - t.row(0))
      .cross(Eigen::RowVector3d(t.row(2) - t.row(0)));
}

}  // namespace musclewarp
