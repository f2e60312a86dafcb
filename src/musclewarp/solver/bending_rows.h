// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/geometry/mean_value_coordinates.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/skeleton/rotation_field.h"

namespace musclewarp {

// Rows that keep the curvature that the fibres of a muscle have at rest, beyond
// the paper. The Laplacian rows keep the shape of the surface in all directions
// alike; a muscle that shortens then lets its fibres bow instead. A row is the
// second difference at an inner point k of a fibre F,
//
//   D_k X = w_k (W_{k-1} - 2 W_k + W_{k+1}) X,
//
// where W_k are the mean value coordinates of F_k in the hull. The weight w_k
// is that for which the squares of all rows add up to w^2 l^2 A times the mean
// of |F''|^2 over all fibres, with the length scale l and the area A of the
// hull: the bending stiffness of the Laplacian rows, times w^2, whatever the
// number and the spacing of the points.
struct BendingRows {
  RowMajorMatrix from_coarse;  // r x N: D, weights included
  Eigen::VectorXd weights;     // r
  std::vector<int> points;     // r: index of F_k in `rest`
  Points rest;                 // #P x 3, mm: the points of all fibres
  RotationField field;         // of the #P points
};

// Makes the rows of fibres (each #Q x 3, at rest, mm, with points at equal
// distances) in the hull with the vertices `coarse_rest`. `stiffness` is w l
// sqrt(A), mm^2. Fibres of fewer than three points or without a length have no
// rows. The field is left to the caller.
BendingRows MakeBendingRows(const std::vector<Points>& fibres,
                            const Points& coarse_rest,
                            const Triangles& coarse_triangles,
                            double stiffness);

// Returns what D X should be, r x 3: the second differences at rest, whose
// edges are stretched as the lines beside them are, turned by the rotation of
// the point. `rotations` and `stretches` are those of the #P points.
Points BendingTargets(const BendingRows& rows,
                      const std::vector<Eigen::Matrix3d>& rotations,
                      const Eigen::VectorXd& stretches);

}  // namespace musclewarp
