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
// cage (#V x 3, #F x 3): a #Q x #V matrix whose rows sum to 1 and reproduce the
// queries, MeanValueCoordinates(q) * cage_points = q, to rounding. Defined and
// continuous everywhere: inside, outside, and on the cage, where they are the
// barycentric coordinates of the face. Positive inside convex cages.
//
// Ju, Schaefer, Warren: Mean value coordinates for closed triangular meshes,
// SIGGRAPH 2005; evaluated with one angle per edge instead of one per corner.
//
// Precondition (CHECKed): the cage has at least four vertices that are not in
// one plane. Any number of threads gives the same result.
RowMajorMatrix MeanValueCoordinates(const Points& queries,
                                    const Points& cage_points,
                                    const Triangles& cage_triangles);

}  // namespace musclewarp
