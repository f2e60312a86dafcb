// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/solver/muscle_model.h"
#include "musclewarp/solver/muscle_target.h"

namespace musclewarp {

// A change of variables after which the linear energy of a muscle is the
// identity. With A = U^T U, the Cholesky factorisation of the normal matrix,
// and X* the unconstrained minimiser,
//
//   Y = U (X - X*)   =>   1/2 |f(X)|^2 = 1/2 |Y|^2 + 1/2 |f(X*)|^2.
//
// The Laplacian, skeleton and attachment rows become N residual blocks y_i. The
// Gauss-Newton matrix is the identity plus one rank-1 term for the volume,
// which conjugate gradients solve in two steps. X and Y are N x 3, mm.
class Whitening {
 public:
  // Computes X* for the target. Keeps a reference to `model`.
  Whitening(const MuscleModel& model, const MuscleTarget& target);

  // The map and its inverse, at the cost of a triangular product or solve.
  Points WhitenedFromCoarse(const Points& coarse) const;
  Points CoarseFromWhitened(const Points& whitened) const;

  // Returns the gradient with respect to Y of a function whose gradient with
  // respect to X is `coarse_gradient`, both N x 3: dg/dY = U^-T dg/dX.
  Points WhitenedGradient(const Points& coarse_gradient) const;

  // Returns R U^-1 for rows R (k x N). Points p = R X of the muscle are then
  // p = (R U^-1) Y + R X*.
  RowMajorMatrix WhitenedRows(const RowMajorMatrix& coarse_rows) const;

 private:
  const MuscleModel& model_;
  Points minimizer_;  // X*
};

}  // namespace musclewarp
