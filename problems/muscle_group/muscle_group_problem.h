// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ceres/problem.h>

#include <memory>
#include <vector>

#include "musclewarp/solver/hard_constraint_solver.h"
#include "musclewarp/solver/muscle_model.h"
#include "musclewarp/solver/muscle_state.h"
#include "musclewarp/solver/muscle_target.h"
#include "musclewarp/solver/volume_evaluator.h"
#include "problems/muscle_group/volume_prefetch.h"
#include "problems/single_muscle/muscle_unknowns.h"

namespace musclewarp {

// Several muscles in one ceres::Problem: the terms of single_muscle/ for each,
// with a volume constraint of its own. Muscles meet only through contact, which
// moves the states and holds vertices between solves.
struct MuscleGroupProblem {
  std::vector<std::unique_ptr<MuscleUnknowns>> unknowns;  // parameter blocks
  std::vector<std::unique_ptr<HardConstraint>> constraints;
  std::vector<std::unique_ptr<VolumeEvaluator>> volumes;
  VolumePrefetch prefetch;
  ceres::Problem problem;

  // Keeps references to the models, and to the states for what contact adds to
  // them.
  MuscleGroupProblem(const std::vector<const MuscleModel*>& models,
                     const std::vector<MuscleTarget>& targets,
                     MuscleFormulation formulation,
                     const std::vector<MuscleState>& states);

  // Writes the coarse vertices of the states to the parameter blocks; contact
  // may have changed.
  void SetStates(const std::vector<MuscleState>& states);

  void SetVolumeMesh(VolumeMesh mesh);
};

}  // namespace musclewarp
