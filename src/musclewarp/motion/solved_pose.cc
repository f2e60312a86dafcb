// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/solved_pose.h"

#include <utility>

#include "musclewarp/base/stopwatch.h"

namespace musclewarp {

std::vector<Points> CoarseOf(const std::vector<MuscleState>& states) {
  std::vector<Points> coarse;
  for (const MuscleState& state : states) coarse.push_back(state.coarse);
  return coarse;
}

SceneState RestState(const PreparedScene& scene) {
  SceneState state;
  state.pose = RestPose(scene.scene);
  for (const PreparedMuscle& muscle : scene.muscles) {
    state.muscles.push_back({muscle.model.coarse_rest, {}});
  }
  return state;
}

std::vector<MuscleState> Predict(const PreparedScene& scene,
                                 const SceneState& before,
                                 const ScenePose& pose,
                                 const PreRotationOptions& pre_rotation) {
  std::vector<MuscleState> states = before.muscles;
  for (size_t i = 0; i < scene.muscles.size(); ++i) {
    const MuscleModel& model = scene.muscles[i].model;
    states[i].coarse +=
        UnconstrainedMinimizer(model, TargetOf(model, pose, pre_rotation)) -
        UnconstrainedMinimizer(model,
                               TargetOf(model, before.pose, pre_rotation));
  }
  return states;
}

SolvedPose SolvePose(const PreparedScene& scene,
                     const ScenePose& pose,
                     const PreRotationOptions& pre_rotation,
                     const MuscleSolver& solver,
                     std::vector<MuscleState> start) {
  std::vector<const MuscleModel*> models;
  std::vector<MuscleTarget> targets;
  for (const PreparedMuscle& muscle : scene.muscles) {
    models.push_back(&muscle.model);
    targets.push_back(TargetOf(muscle.model, pose, pre_rotation));
  }
  SolvedPose solved;
  solved.states = std::move(start);
  const Stopwatch solving;
  SolveEachOnItsOwn(solver, models, targets, &solved.states, &solved.summaries);
  solved.solve_ms = solving.Milliseconds();
  return solved;
}

SolvedPose SolveWithRows(const PreparedScene& scene,
                         const SolvedPose& without_rows,
                         const ScenePose& pose,
                         const PreRotationOptions& pre_rotation,
                         const MuscleSolver& solver,
                         std::vector<ContactRows> contact,
                         const std::vector<MuscleState>& start) {
  std::vector<size_t> with_rows;
  std::vector<const MuscleModel*> models;
  std::vector<MuscleTarget> targets;
  std::vector<MuscleState> states;
  for (size_t i = 0; i < scene.muscles.size(); ++i) {
    if (contact[i].rows.size() == 0) continue;
    with_rows.push_back(i);
    models.push_back(&scene.muscles[i].model);
    targets.push_back(TargetOf(*models.back(), pose, pre_rotation));
    targets.back().one_sided = contact[i].rows;
    states.push_back(start[i]);
  }
  SolvedPose solved = without_rows;
  solved.contact = std::move(contact);
  std::vector<SolverSummary> summaries;
  const Stopwatch solving;
  SolveEachOnItsOwn(solver, models, targets, &states, &summaries);
  solved.solve_ms += solving.Milliseconds();
  for (size_t k = 0; k < with_rows.size(); ++k) {
    solved.states[with_rows[k]] = std::move(states[k]);
    const SolverSummary& without = without_rows.summaries[with_rows[k]];
    SolverSummary& summary = solved.summaries[with_rows[k]];
    summary = MergedSummary(without, std::move(summaries[k]));
    if (!without.IsSolutionUsable()) {
      summary.stop_reason = without.stop_reason;
      summary.message = without.message;
    }
  }
  return solved;
}

}  // namespace musclewarp
