// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/solver/hard_constraint_solver.h"
#include "musclewarp/solver/muscle_model.h"
#include "musclewarp/solver/muscle_target.h"
#include "musclewarp/solver/solver_summary.h"
#include "problems/single_muscle/muscle_unknowns.h"

namespace musclewarp {

struct SingleMuscleOptions {
  MuscleFormulation formulation = MuscleFormulation::kWhitened;
  HardConstraintOptions hard_constraint;

  // While steps or the volume error, the latter as a thickness, are above this,
  // mm, the volume is that of the coarse mesh; then that of the fine mesh.
  double fine_volume_threshold = 1;

  // Returns options for a formulation, with a linear solver that suits it:
  // conjugate gradients for whitened unknowns, dense Cholesky for blocks.
  static SingleMuscleOptions For(MuscleFormulation formulation);

  // Returns false and names the field, its value and the rule if a field, one
  // of hard_constraint included, is out of range.
  bool IsValid(std::string* error) const;
};

// Deforms one muscle with Ceres: minimises 1/2 |f(X)|^2, and the one-sided rows
// of the target if there are any, subject to V(W X) = V_hat (paper eq. 2.8 and
// 2.9). It reaches the same minimum as the reference solver (SolveGaussNewton).
//
// `coarse` (N x 3, mm) is the start on entry and the result on return.
// `summary` says whether the solver converged; nothing is thrown.
// Preconditions (CHECKed): the options are valid, `coarse` has a row for each
// coarse vertex of the model.
void SolveSingleMuscle(const MuscleModel& model,
                       const MuscleTarget& target,
                       const SingleMuscleOptions& options,
                       Points* coarse,
                       SolverSummary* summary);

}  // namespace musclewarp
