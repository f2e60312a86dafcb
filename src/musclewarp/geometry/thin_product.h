// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/geometry/mean_value_coordinates.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Products of a dense matrix with the three columns of points. The general
// product of Eigen sorts the matrix into blocks first, which takes longer than
// so thin a product.

// Returns matrix * points, for K x N and N x 3.
Points ThinProduct(const RowMajorMatrix& matrix, const Points& points);

// Returns matrix^T * points, N x 3, for K x N and K x 3.
Points ThinTransposedProduct(const RowMajorMatrix& matrix,
                             const Points& points);

// The same with some rows of the matrix, #R.
Points ThinProduct(const RowMajorMatrix& matrix,
                   const std::vector<int>& rows,
                   const Points& points);
Points ThinTransposedProduct(const RowMajorMatrix& matrix,
                             const std::vector<int>& rows,
                             const Points& points);

}  // namespace musclewarp
