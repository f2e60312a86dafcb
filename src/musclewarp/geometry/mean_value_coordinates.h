// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// A dense matrix whose rows are read one after the other.
using RowMajorMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// Mean value coordinates of `queries` (#Q x 3) in a closed triangle mesh, the
// cage: #Q x #V with MeanValueCoordinates(q) * cage_points = q.
RowMajorMatrix MeanValueCoordinates(const Points& queries,
                                    const Points& cage_points,
                                    const Triangles& cage_triangles);

}  // namespace musclewarp
