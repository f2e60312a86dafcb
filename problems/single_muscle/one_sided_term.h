// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ceres/cost_function.h>

#include "musclewarp/solver/one_sided_rows.h"
#include "problems/single_muscle/muscle_unknowns.h"

namespace musclewarp {

// The one-sided rows of the fine vertices in contact (OneSidedRows):
//
//   r_k = weight max(0, level_k - n_k . (W X)_v(k)),    K residuals, mm times
//                                                       the weight.
//
// Parameter blocks: all coarse vertices x_j, or all whitened unknowns y_j, each
// of size 3. One residual block for all rows of a muscle: each touches all
// unknowns, and X is found from Y once for all.
class OneSidedTerm : public ceres::CostFunction {
 public:
  // Keeps pointers to `unknowns` and `rows`.
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
