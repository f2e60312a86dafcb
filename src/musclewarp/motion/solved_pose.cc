// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/solved_pose.h"

#include <utility>

#include "musclewarp/base/parallel_for.h"
#include "musclewarp/base/stopwatch.h"

namespace musclewarp {

MuscleModels ModelsOf(const PreparedScene& scene) {
  MuscleModels models;
  for (const PreparedMuscle& muscle : scene.muscles) {
    models.push_back(&muscle.model);
  }
  return models;
}

MuscleModels ModelsOf(const std::vector<const PreparedMuscle*>& muscles) {
  MuscleModels models;
  for (const PreparedMuscle* muscle : muscles) {
    models.push_back(&muscle->model);
  }
  return models;
}

std::vector<Points> CoarseOf(const std::vector<MuscleState>& states) {
  std::vector<Points> coarse;
  for (const MuscleState& state : states) coarse.push_back(state.coarse);
  return coarse;
}

std::vector<MuscleState> StatesOf(const std::vector<Points>& coarse) {
  std::vector<MuscleState> states;
  for (const Points& points : coarse) states.push_back({points, {}});
  return states;
}

std::vector<MuscleState> Predict(const MuscleModels& models,
                                 std::vector<MuscleState> before,
                                 const ScenePose& from,
                                 const ScenePose& pose,
                                 const PreRotationOptions& pre_rotation) {
  ParallelFor(models.size(), [&](size_t i) {
    const MuscleModel& model = *models[i];
    if (!model.HasLines()) return;
    before[i].coarse +=
        UnconstrainedMinimizer(model, TargetOf(model, pose, pre_rotation)) -
        UnconstrainedMinimizer(model, TargetOf(model, from, pre_rotation));
  });
  return before;
}

SolvedPose SolvePose(const MuscleModels& models,
                     const ScenePose& pose,
                     const PreRotationOptions& pre_rotation,
                     const MuscleSolver& solver,
                     std::vector<MuscleState> start) {
  std::vector<MuscleTarget> targets(models.size());
  ParallelFor(models.size(), [&](size_t i) {
    targets[i] = TargetOf(*models[i], pose, pre_rotation);
  });
  SolvedPose solved;
  solved.states = std::move(start);
  const Stopwatch solving;
  SolveEachOnItsOwn(solver, models, targets, &solved.states, &solved.summaries);
  solved.solve_ms = solving.Milliseconds();
  return solved;
}

SolvedPose SolveWithRows(const MuscleModels& models,
                         const SolvedPose& without_rows,
                         const ScenePose& pose,
                         const PreRotationOptions& pre_rotation,
                         const MuscleSolver& solver,
                         const std::vector<OneSidedRows>& rows,
                         const std::vector<MuscleState>& start) {
  std::vector<size_t> with_rows;
  MuscleModels models_with_rows;
  std::vector<MuscleTarget> targets;
  std::vector<MuscleState> states;
  for (size_t i = 0; i < models.size(); ++i) {
    if (rows[i].size() == 0) continue;
    with_rows.push_back(i);
    models_with_rows.push_back(models[i]);
    targets.push_back(TargetOf(*models[i], pose, pre_rotation));
    targets.back().one_sided = rows[i];
    states.push_back(start[i]);
  }
  SolvedPose solved = without_rows;
  std::vector<SolverSummary> summaries;
  const Stopwatch solving;
  SolveEachOnItsOwn(solver, models_with_rows, targets, &states, &summaries);
  solved.solve_ms += solving.Milliseconds();
  for (size_t k = 0; k < with_rows.size(); ++k) {
    const size_t i = with_rows[k];
    solved.states[i] = std::move(states[k]);
    const SolverSummary& without = without_rows.summaries[i];
    SolverSummary& summary = solved.summaries[i];
    summary = MergedSummary(without, std::move(summaries[k]));
    if (!without.IsSolutionUsable()) {
      summary.stop_reason = without.stop_reason;
      summary.message = without.message;
    }
  }
  return solved;
}

}  // namespace musclewarp
