// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/SparseCore>
#include <string>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

using SparseMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

struct CotangentLaplacianOptions {
  // Divide every row by the sum of its weights, so that (L X)_i is a length in
  // the unit of X and large and small triangles count alike.
  bool normalize_rows = true;

  // Cotangents are bounded to this in size, radians: an angle nearer to 0 or pi
  // belongs to a sliver, whose cotangent would outweigh the rest of the mesh.
  double min_angle = 0.05;

  // A weight is at least this, so that every row sum is positive: obtuse
  // triangle pairs give negative weights, which can cancel a row.
  double min_weight = 0.05;

  bool IsValid(std::string* error) const;
};

// The discrete Laplacian of paper eq. (2.1) to (2.3), #V x #V, in the
// convention (L X)_i = sum_j w_ij (x_j - x_i) with the cotangent weights
// w_ij = cot a_ij + cot b_ij of eq. (2.2): the diagonal is minus the row sum,
// constants are in the null space. Rows are normalised, so L is not symmetric.
SparseMatrix CotangentLaplacian(const Points& points,
                                const Triangles& triangles,
                                const CotangentLaplacianOptions& options);

}  // namespace musclewarp
