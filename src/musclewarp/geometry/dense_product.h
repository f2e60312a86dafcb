// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/geometry/mean_value_coordinates.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Products of a tall dense matrix (n x N), such as a matrix of mean value
// coordinates, with points. The solvers spend most of their time here. Each
// product reads the matrix once, which is what it costs, and runs on one
// thread: a single product is too short to be shared, so that callers run
// muscles on several threads instead.

// Returns matrix * points, n x 3. It carries coarse points (N x 3) to the fine
// mesh.
Points Product(const RowMajorMatrix& matrix, const Points& points);

// Returns matrix^T * points, N x 3. It carries gradients with respect to fine
// points (n x 3) back to the coarse ones.
Points TransposedProduct(const RowMajorMatrix& matrix, const Points& points);

// The same for several sets of points, which cost less together than one after
// the other: the matrix is read once for all of them.
std::vector<Points> Products(const RowMajorMatrix& matrix,
                             const std::vector<Points>& sets);
std::vector<Points> TransposedProducts(const RowMajorMatrix& matrix,
                                       const std::vector<Points>& sets);

}  // namespace musclewarp
