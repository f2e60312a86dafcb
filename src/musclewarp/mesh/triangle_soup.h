// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace musclewarp {

// Vertex positions, #V x 3, in millimetres. The storage is row-major: a vertex
// is three consecutive doubles and can serve as a parameter block of Ceres.
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

// The vertex indices of triangles, #F x 3, counted from zero. The corners run
// counterclockwise seen from outside.
using Triangles = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;

// Triangles with shared points and no promise about how they are connected:
// what mesh files hold, and what readers return. Indices are in range and
// coordinates are finite; everything else may be wrong (see defects.h) until
// RepairMesh has made a closed manifold of it.
struct TriangleSoup {
  Points points;
  Triangles triangles;
};

}  // namespace musclewarp
