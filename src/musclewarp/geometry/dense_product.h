// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

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

}  // namespace musclewarp
