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

// The models of the muscles of a scene, in any order.
using MuscleModels = std::vector<const MuscleModel*>;

MuscleModels ModelsOf(const PreparedScene& scene);
MuscleModels ModelsOf(const std::vector<const PreparedMuscle*>& muscles);

// The solution of all muscles of a scene for one pose.
struct SolvedPose {
  std::vector<MuscleState> states;
  std::vector<SolverSummary> summaries;
  double solve_ms = 0;
};

// Returns the coarse vertices of muscles, N x 3 each, mm.
std::vector<Points> CoarseOf(const std::vector<MuscleState>& states);

// Returns the states with the coarse vertices `coarse`, without corrections.
std::vector<MuscleState> StatesOf(const std::vector<Points>& coarse);

// Predicts the states of the muscles in a pose from their states `before` in
// the pose `from`: each muscle moves as its unconstrained minimizer does
// (docs/method.md, "Motions").
std::vector<MuscleState> Predict(const MuscleModels& models,
                                 std::vector<MuscleState> before,
                                 const ScenePose& from,
                                 const ScenePose& pose,
                                 const PreRotationOptions& pre_rotation);

// Solves every muscle on its own for one pose, starting from `start`.
SolvedPose SolvePose(const MuscleModels& models,
                     const ScenePose& pose,
                     const PreRotationOptions& pre_rotation,
                     const MuscleSolver& solver,
                     std::vector<MuscleState> start);

// Solves the muscles with one-sided rows, starting from `start`; the others
// keep their solution in `without_rows`. `rows`: one set per muscle. Summaries
// add up the iterations and times of both solves. A muscle whose solve without
// rows failed counts as failed, as its displacement by contact is measured
// relative to that solution.
SolvedPose SolveWithRows(const MuscleModels& models,
                         const SolvedPose& without_rows,
                         const ScenePose& pose,
                         const PreRotationOptions& pre_rotation,
                         const MuscleSolver& solver,
                         const std::vector<OneSidedRows>& rows,
                         const std::vector<MuscleState>& start);

}  // namespace musclewarp
