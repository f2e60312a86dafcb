// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/motion/group_solver.h"
#include "musclewarp/motion/prepared_scene.h"
#include "musclewarp/motion/scene_contact.h"
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

// The muscles of a scene, solved for one pose.
struct SolvedPose {
  std::vector<MuscleState> states;
  std::vector<SolverSummary> summaries;
  double solve_ms = 0;
};

// Moves the muscles to one pose. Without `state` they start from rest, on their
// own; or with `contact` (null: without) together, from the shape they have
// without contact and volume constraint: bones do not pass through their rest
// pose on the way. With `state` they start from there, moved on as the
// unconstrained shapes move.
SolvedPose SolvePose(const PreparedScene& scene,
                     const SceneContact* contact,
                     const ScenePose& pose,
                     const PreRotationOptions& pre_rotation,
                     const GroupSolver& solver,
                     const SceneState* state);

// The muscles in one pose with contact rows, one set each: from what they are
// without, `free`, and from `start`. Of the two summaries of a muscle
// iterations and times are added up; a solve that failed without contact counts
// as failed, as displacement by contact is measured against it.
SolvedPose SolveWithContactRows(const PreparedScene& scene,
                                const SolvedPose& free,
                                const ScenePose& pose,
                                const PreRotationOptions& pre_rotation,
                                const GroupSolver& solver,
                                std::vector<OneSidedRows> rows,
                                std::vector<MuscleState> start);

}  // namespace musclewarp
