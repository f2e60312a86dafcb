// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ceres/cost_function.h>

#include "musclewarp/solver/hard_constraint_solver.h"
#include "musclewarp/solver/volume_evaluator.h"
#include "problems/single_muscle/muscle_unknowns.h"

namespace musclewarp {

// The volume constraint, paper eq. (2.6), (2.7) and (2.9), as one residual with
// the penalty and multiplier of a HardConstraint:
//
//   r = sqrt(penalty) (c - target + multiplier / penalty),
//   c = (V(W X) - V_hat) / area.
//
// Divided by the rest area of the fine mesh, c is the volume error as a
// thickness, mm, so that one penalty suits muscles of every size.
//
// Parameter blocks: the N blocks of MuscleUnknowns, each of size 3. The
// derivative is written by hand: the fine mesh depends on all blocks, and
// automatic differentiation would cost N times as much.
class VolumeTerm : public ceres::CostFunction {
 public:
  // Keeps pointers to all three; penalty, multiplier and target are read at
  // every evaluation. Vertices that the corrections of `evaluator` hold have
  // zero rows in the Jacobian with respect to X.
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
