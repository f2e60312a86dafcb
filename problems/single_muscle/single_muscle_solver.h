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

  // The volume is taken from the coarse mesh until steps and volume error (as a
  // thickness) are below this, mm; then from the fine mesh.
  double fine_volume_threshold = 0.05;

  // Options for a formulation, with a linear solver that suits it.
  static SingleMuscleOptions For(MuscleFormulation formulation);

  bool IsValid(std::string* error) const;
};

// Deforms one muscle with Ceres: the minimum of the linear energy at the volume
// of the fine rest mesh. `coarse` (N x 3) is the start and the result.
// Precondition (CHECKed): the options are valid.
void SolveSingleMuscle(const MuscleModel& model,
                       const MuscleTarget& target,
                       const SingleMuscleOptions& options,
                       Points* coarse,
                       SolverSummary* summary);

}  // namespace musclewarp
