// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/SparseCore>
#include <string>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// A sparse matrix whose rows are contiguous, so that a product with a vector
// reads the matrix in the order in which it is stored.
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

// The options of CotangentLaplacian. The defaults suit muscle hulls of some
// hundred vertices.
struct CotangentLaplacianOptions {
  // If true, every row is divided by the sum of its weights. Then (L X)_i is a
  // length in the unit of X, and large and small triangles count alike.
  bool normalize_rows = true;

  // No cotangent is larger in size than that of this angle, rad. An angle
  // nearer to 0 or pi belongs to a sliver, whose cotangent would outweigh the
  // rest of the mesh.
  double min_angle = 0.05;

  // No weight w_ij is smaller than this, so that every row sum is positive.
  // Pairs of obtuse triangles have negative cotangent sums, which can cancel a
  // row.
  double min_weight = 0.05;

  // Returns true if the options can be used; otherwise sets *error to a
  // sentence that names the field and the rule.
  bool IsValid(std::string* error) const;
};

// Returns the discrete Laplacian L (#V x #V) of a triangle mesh, which measures
// how a vertex lies relative to its neighbours. Keeping L X keeps the shape of
// the surface while the mesh is deformed (paper, eq. 2.1 to 2.3):
//
//   (L X)_i = sum_j w_ij (x_j - x_i),   w_ij = cot a_ij + cot b_ij,
//
// where a_ij and b_ij are the angles opposite to the edge ij. The diagonal is
// minus the sum of the other entries of the row, so that constants are in the
// null space and L is negative semi-definite before rows are normalised.
// Normalised rows make L unsymmetric. A vertex without triangles has an empty
// row.
//
// `points` is #V x 3 and `triangles` #F x 3. Precondition (CHECKed): the
// options are valid.
SparseMatrix CotangentLaplacian(const Points& points,
                                const Triangles& triangles,
                                const CotangentLaplacianOptions& options);

}  // namespace musclewarp
