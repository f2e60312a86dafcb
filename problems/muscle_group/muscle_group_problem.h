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

// The optimisation problem of several muscles: one ceres::Problem that has the
// terms of single_muscle/ for each muscle and a volume constraint of its own
// for each. No term couples two muscles. They interact only through contact,
// which changes the states and holds vertices between solves.
//
// In the problem, parameter and residual blocks are in the order of the
// muscles.
struct MuscleGroupProblem {
  // One entry per muscle each. `volumes` evaluate the constraints with the
  // corrections of the states, so that held vertices stay where they are held.
  std::vector<std::unique_ptr<MuscleUnknowns>> unknowns;
  std::vector<std::unique_ptr<HardConstraint>> constraints;
  std::vector<std::unique_ptr<VolumeEvaluator>> volumes;

  // Evaluates the volumes in parallel, before Ceres asks for them.
  VolumePrefetch prefetch;
  ceres::Problem problem;

  // Assembles the problem in the given formulation, starting from the coarse
  // vertices of `states`. Keeps references to the models, to the targets and to
  // the corrections of the states; the problem points into this struct, which
  // must not be moved.
  // Precondition (CHECKed): as many models as targets and states.
  MuscleGroupProblem(const std::vector<const MuscleModel*>& models,
                     const std::vector<MuscleTarget>& targets,
                     MuscleFormulation formulation,
                     const std::vector<MuscleState>& states);
  MuscleGroupProblem(const MuscleGroupProblem&) = delete;
  MuscleGroupProblem& operator=(const MuscleGroupProblem&) = delete;

  // Writes the coarse vertices of `states` to the parameter blocks, and has the
  // volumes take notice of changed corrections.
  void SetStates(const std::vector<MuscleState>& states);

  // Selects the mesh whose volume is constrained, for all muscles.
  void SetVolumeMesh(VolumeMesh mesh);
};

}  // namespace musclewarp
