// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// A dense matrix whose rows are contiguous.
using RowMajorMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// Returns the mean value coordinates of points in a cage, a closed triangle
// mesh around or near them. They carry a deformation of the cage to the points:
// with the matrix W of the rest pose, W * (moved cage points) are the moved
// points.
//
//   const RowMajorMatrix w = MeanValueCoordinates(fine, hull, hull_triangles);
//   const Points moved_fine = w * moved_hull;
//
// The result is #Q x #V for queries (#Q x 3) and a cage of #V vertices. Its
// rows sum to 1 and reproduce the queries, W * cage_points = queries, up to
// rounding. The coordinates are defined and continuous everywhere: inside the
// cage, outside, and on it, where they are the barycentric coordinates of the
// triangle. They are positive inside convex cages.
//
// Source: Ju, Schaefer and Warren, "Mean value coordinates for closed
// triangular meshes", SIGGRAPH 2005, evaluated with one angle per edge instead
// of one per corner. Queries near a triangle or its plane are evaluated with
// more digits.
//
// Precondition (CHECKed): the cage has at least four vertices that are not in
// one plane. The result does not depend on the number of threads.
RowMajorMatrix MeanValueCoordinates(const Points& queries,
                                    const Points& cage_points,
                                    const Triangles& cage_triangles);

}  // namespace musclewarp
