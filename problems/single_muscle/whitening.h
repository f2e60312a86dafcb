// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/solver/muscle_model.h"
#include "musclewarp/solver/muscle_target.h"

namespace musclewarp {

// Unknowns in which the linear energy of a muscle is the identity: with
// A = U^T U and X* its unconstrained minimiser,
//
//   Y = U (X - X*)   =>   1/2 |f(X)|^2 = 1/2 |Y|^2 + 1/2 |f(X*)|^2.
//
// The Laplacian, skeleton and attachment rows become N residual blocks y_i, and
// the Gauss-Newton matrix the identity plus one rank-1 term for the volume,
// which conjugate gradients solve in two steps. Positions N x 3, mm.
class Whitening {
 public:
  // Keeps a reference to `model`.
  Whitening(const MuscleModel& model, const MuscleTarget& target);

  Points WhitenedFromCoarse(const Points& coarse) const;
  Points CoarseFromWhitened(const Points& whitened) const;
  // dg/dY = U^-T dg/dX.
  Points WhitenedGradient(const Points& coarse_gradient) const;
  // Of rows that give points p = R X (k x N) those with p = R U^-1 Y + R X*.
  RowMajorMatrix WhitenedRows(const RowMajorMatrix& coarse_rows) const;

 private:
  const MuscleModel& model_;
  Points minimizer_;  // X*
};

}  // namespace musclewarp
