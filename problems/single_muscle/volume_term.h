// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ceres/cost_function.h>

#include "musclewarp/solver/hard_constraint_solver.h"
#include "musclewarp/solver/volume_evaluator.h"
#include "problems/single_muscle/muscle_unknowns.h"

namespace musclewarp {

// The volume constraint, paper eq. (2.6), (2.7) and (2.9), hardened by penalty
// and multiplier (HardConstraint), 1 residual:
//
//   r = sqrt(penalty) (c - target + multiplier / penalty),
//   c = (V(W X) - V_hat) / area.
//
// Divided by the rest area of the fine mesh, c is the volume error as a
// thickness, mm, which makes one penalty serve muscles of every size.
//
// Parameter blocks: all coarse vertices x_j, or all whitened unknowns y_j, each
// of size 3. The derivative is written by hand: the fine mesh follows
// all blocks, automatic differentiation would cost N times as much.
class VolumeTerm : public ceres::CostFunction {
 public:
  // Keeps pointers to all three. The vertices that corrections holds have zero
  // rows in the Jacobian.
  VolumeTerm(const MuscleUnknowns* unknowns,
             VolumeEvaluator* evaluator,
             const HardConstraint* constraint);

  bool Evaluate(double const* const* parameters,
                double* residual,
                double** jacobians) const override;

 private:
  const MuscleUnknowns& unknowns_;
  VolumeEvaluator& evaluator_;
  const HardConstraint& constraint_;
};

}  // namespace musclewarp
