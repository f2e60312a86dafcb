// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/certified_contact/plane_carrier.h"
#include "musclewarp/motion/muscle_solvers.h"
#include "musclewarp/motion/prepared_scene.h"
#include "musclewarp/solver/muscle_state.h"
#include "musclewarp/solver/muscle_target.h"
#include "musclewarp/solver/one_sided_rows.h"
#include "musclewarp/solver/solver_summary.h"

namespace musclewarp {

// The muscles of a scene in a pose: where the next frame of a motion starts.
struct SceneState {
  ScenePose pose;
  std::vector<MuscleState> muscles;
  // With certified contact, the coarse vertices of each muscle as they would be
  // without contact, N x 3, mm. Else there are none.
  std::vector<Points> free_coarse;
};

// The one-sided rows with which contact had a muscle solved, and what the plane
// of each row goes along with. Muscles and bones are numbered as in the scene.
struct ContactRows {
  OneSidedRows rows;
  std::vector<PlaneCarrier> carriers;
};

// The muscles of a scene, solved for one pose.
struct SolvedPose {
  std::vector<MuscleState> states;
  std::vector<SolverSummary> summaries;
  double solve_ms = 0;

  // Of each muscle; empty if all were solved without.
  std::vector<ContactRows> contact;
};

// Returns the coarse vertices of muscles.
std::vector<Points> CoarseOf(const std::vector<MuscleState>& states);

// Returns the state of a scene with every muscle at rest.
SceneState RestState(const PreparedScene& scene);

// Returns where the muscles are expected in a pose if they were in `before`:
// they are moved on as their unconstrained shapes move (docs/method.md,
// "Motions").
std::vector<MuscleState> Predict(const PreparedScene& scene,
                                 const SceneState& before,
                                 const ScenePose& pose,
                                 const PreRotationOptions& pre_rotation);

// Solves every muscle on its own for one pose, from `start`.
SolvedPose SolvePose(const PreparedScene& scene,
                     const ScenePose& pose,
                     const PreRotationOptions& pre_rotation,
                     const MuscleSolver& solver,
                     std::vector<MuscleState> start);

// Solves the muscles that contact has rows for (one set for each muscle) with
// them, from `start`; the others are as in `without_rows`. Of the two summaries
// of a muscle iterations and times are added up. A muscle that could not be
// solved without rows counts as failed, as its displacement by contact is
// measured against that solution.
SolvedPose SolveWithRows(const PreparedScene& scene,
                         const SolvedPose& without_rows,
                         const ScenePose& pose,
                         const PreRotationOptions& pre_rotation,
                         const MuscleSolver& solver,
                         std::vector<ContactRows> contact,
                         const std::vector<MuscleState>& start);

}  // namespace musclewarp
