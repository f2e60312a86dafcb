// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace musclewarp {

// Vertex positions, #V x 3, millimetres. Row-major: one vertex is three
// consecutive doubles, usable as a Ceres parameter block.
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

// Vertex indices of triangles, #F x 3, counterclockwise seen from outside.
using Triangles = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;

// Triangles with shared points and no promise about connectivity: what files
// hold. Indices are in range and points finite; everything else may be wrong.
struct TriangleSoup {
  Points points;
  Triangles triangles;
};

}  // namespace musclewarp
