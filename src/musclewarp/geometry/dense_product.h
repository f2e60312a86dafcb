// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/geometry/mean_value_coordinates.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Products of a tall dense matrix (n x N, such as mean value coordinates) with
// points, the hot spots of every solver. One pass over the matrix each, which
// is what they cost. On one thread: muscles are what is spread over threads, a
// product is too short.

// matrix * points: n x 3.
Points Product(const RowMajorMatrix& matrix, const Points& points);

// matrix^T * points: N x 3.
Points TransposedProduct(const RowMajorMatrix& matrix, const Points& points);

}  // namespace musclewarp
