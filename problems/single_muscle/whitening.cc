// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "problems/single_muscle/whitening.h"

namespace musclewarp {

Whitening::Whitening(const MuscleModel& model, const MuscleTarget& target)
    : model_(model), minimizer_(UnconstrainedMinimizer(model, target)) {}

Points Whitening::WhitenedFromCoarse(const Points& coarse) const {
  return model_.normal_matrix.matrixU() * (coarse - minimizer_);
}

Points Whitening::CoarseFromWhitened(const Points& whitened) const {
  return minimizer_ + model_.normal_matrix.matrixU().solve(whitened);
}

Points Whitening::WhitenedGradient(const Points& coarse_gradient) const {
  return model_.normal_matrix.matrixL().solve(coarse_gradient);
}

RowMajorMatrix Whitening::WhitenedRows(
    const RowMajorMatrix& coarse_rows) const {
  return model_.normal_matrix.matrixL()
      .solve(coarse_rows.transpose())
      .transpose();
}

}  // namespace musclewarp
