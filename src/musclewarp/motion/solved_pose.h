// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/motion/muscle_solvers.h"
#include "musclewarp/preparation/prepared_scene.h"
#include "musclewarp/solver/muscle_state.h"
#include "musclewarp/solver/muscle_target.h"
#include "musclewarp/solver/one_sided_rows.h"
#include "musclewarp/solver/solver_summary.h"

namespace musclewarp {

// The models of the muscles of a scene, in whatever order.
using MuscleModels = std::vector<const MuscleModel*>;

MuscleModels ModelsOf(const PreparedScene& scene);
MuscleModels ModelsOf(const std::vector<const PreparedMuscle*>& muscles);

// The muscles of a scene, solved for one pose.
struct SolvedPose {
  std::vector<MuscleState> states;
  std::vector<SolverSummary> summaries;
  double solve_ms = 0;
};

// Returns the coarse vertices of muscles, N x 3 each, mm.
std::vector<Points> CoarseOf(const std::vector<MuscleState>& states);

// Returns the states of muscles with these coarse vertices, without
// corrections.
std::vector<MuscleState> StatesOf(const std::vector<Points>& coarse);

// Returns where the muscles are expected in a pose if they were in `before` in
// the pose `from`: they are moved on as their unconstrained shapes move
// (docs/method.md, "Motions").
std::vector<MuscleState> Predict(const MuscleModels& models,
                                 std::vector<MuscleState> before,
                                 const ScenePose& from,
                                 const ScenePose& pose,
                                 const PreRotationOptions& pre_rotation);

// Solves every muscle on its own for one pose, from `start`.
SolvedPose SolvePose(const MuscleModels& models,
                     const ScenePose& pose,
                     const PreRotationOptions& pre_rotation,
                     const MuscleSolver& solver,
                     std::vector<MuscleState> start);

// Solves the muscles that have one-sided rows (a set for each muscle) with
// them, from `start`; the others are as in `without_rows`. Of the two summaries
// of a muscle iterations and times are added up. A muscle that could not be
// solved without rows counts as failed, as its displacement by contact is
// measured against that solution.
SolvedPose SolveWithRows(const MuscleModels& models,
                         const SolvedPose& without_rows,
                         const ScenePose& pose,
                         const PreRotationOptions& pre_rotation,
                         const MuscleSolver& solver,
                         const std::vector<OneSidedRows>& rows,
                         const std::vector<MuscleState>& start);

}  // namespace musclewarp
