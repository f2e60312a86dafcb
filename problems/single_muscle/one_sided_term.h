// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ceres/cost_function.h>

#include "musclewarp/solver/one_sided_rows.h"
#include "problems/single_muscle/muscle_unknowns.h"

namespace musclewarp {

// Keeps fine vertices softly on one side of planes (OneSidedRows):
//
//   r_k = weight max(0, level_k - n_k . (W X)_v(k)),    K residuals, mm times
//                                                       the weight.
//
// The Jacobian has a jump where a vertex lies on its plane; there the row
// counts as inactive, with a derivative of zero.
//
// Parameter blocks: the N blocks of MuscleUnknowns, each of size 3. One cost
// function serves all rows of a muscle, because each row depends on all blocks
// and X is computed from them once for all rows. The derivative is written by
// hand for the same reason.
class OneSidedTerm : public ceres::CostFunction {
 public:
  // Keeps pointers to `unknowns` and `rows`.
  // Precondition: there is at least one row.
  OneSidedTerm(const MuscleModel& model,
               const OneSidedRows* rows,
               const MuscleUnknowns* unknowns);

  bool Evaluate(double const* const* parameters,
                double* residuals,
                double** jacobians) const override;

 private:
  const MuscleUnknowns& unknowns_;
  const OneSidedRows& rows_;
  const RowMajorMatrix fine_from_coarse_;    // K x N
  const RowMajorMatrix fine_from_unknowns_;  // K x N
};

}  // namespace musclewarp
