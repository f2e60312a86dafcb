// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/geometry/mean_value_coordinates.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// The matrix W (n x N) that carries coarse points to fine ones, as mean value
// coordinates do. The solvers spend most of their time reading it, so that it
// is kept in single precision, which halves that time. By itself rounding would
// shift rest and rigid motions by 1e-7 of the coordinates; corrections of the
// columns of four coarse vertices give every row the sum and the point that it
// had. What remains is 1e-7 of how far coarse points move against each other.
struct FineMap {
  Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>
      weights;                 // n x N
  std::vector<int> corrected;  // the four columns
  RowMajorMatrix corrections;  // n x 4, to be added to them

  Eigen::Index rows() const { return weights.rows(); }
  Eigen::Index cols() const { return weights.cols(); }
};

// Rounds a matrix (n x N) whose rows carry coarse points at rest (N x 3) to the
// fine ones. Precondition (CHECKed): there are at least four coarse points.
FineMap MakeFineMap(const RowMajorMatrix& matrix, const Points& coarse);

// Returns rows of W, in double precision: #R x N.
RowMajorMatrix RowsOf(const FineMap& map, const std::vector<int>& rows);

// Each product reads the matrix once, which is what it costs, and runs on one
// thread: a single product is too short to be shared, so that callers run
// muscles on several threads instead. Sums are in double precision.

// Returns W * points, n x 3. It carries coarse points (N x 3) to the fine mesh.
Points Product(const FineMap& map, const Points& points);

// Returns W^T * points, N x 3. It carries gradients with respect to fine points
// (n x 3) back to the coarse ones.
Points TransposedProduct(const FineMap& map, const Points& points);

// The same for several sets of points, which cost less together than one after
// the other: the matrix is read once for all of them.
std::vector<Points> Products(const FineMap& map,
                             const std::vector<Points>& sets);
std::vector<Points> TransposedProducts(const FineMap& map,
                                       const std::vector<Points>& sets);

}  // namespace musclewarp
