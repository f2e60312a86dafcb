// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/solved_pose.h"

#include <Eigen/LU>
#include <optional>
#include <utility>

#include "musclewarp/base/stopwatch.h"
#include "musclewarp/scene/line_targets.h"

namespace musclewarp {

SolvedPose SolvePose(const PreparedScene& scene,
                     const SceneContact* contact,
                     const ScenePose& pose,
                     const PreRotationOptions& pre_rotation,
                     const GroupSolver& solver,
                     const SceneState* state) {
  std::vector<const MuscleModel*> models;
  std::vector<MuscleTarget> targets;
  SolvedPose solved;
  for (size_t i = 0; i < scene.muscles.size(); ++i) {
    const MuscleModel& model = scene.muscles[i].model;
    models.push_back(&model);
    targets.push_back(TargetOf(model, pose, pre_rotation));
    MuscleState start;
    if (state) {
      start = state->muscles[i];
      start.coarse += UnconstrainedMinimizer(model, targets.back()) -
                      UnconstrainedMinimizer(
                          model, TargetOf(model, state->pose, pre_rotation));
    } else if (contact) {
      start.coarse = UnconstrainedMinimizer(model, targets.back());
    } else {
      start.coarse = model.coarse_rest;
    }
    solved.states.push_back(std::move(start));
  }
  std::optional<GroupContact> group_contact;
  if (contact) group_contact = ContactInPose(scene, *contact, pose);
  if (contact && state) {
    std::vector<Eigen::Matrix4d> now_from_before;
    for (const PreparedBone& bone : scene.bones) {
      now_from_before.push_back(
          BodyTransform(pose, bone.body) *
          BodyTransform(state->pose, bone.body).inverse());
    }
    group_contact->FollowOn(state->muscles, std::move(now_from_before));
  }
  const Stopwatch solving;
  solver(models,
         targets,
         group_contact ? &*group_contact : nullptr,
         &solved.states,
         &solved.summaries);
  solved.solve_ms = solving.Milliseconds();
  return solved;
}

SolvedPose SolveWithContactRows(const PreparedScene& scene,
                                const SolvedPose& free,
                                const ScenePose& pose,
                                const PreRotationOptions& pre_rotation,
                                const GroupSolver& solver,
                                std::vector<OneSidedRows> rows,
                                std::vector<MuscleState> start) {
  std::vector<size_t> in_contact;
  std::vector<const MuscleModel*> models;
  std::vector<MuscleTarget> targets;
  std::vector<MuscleState> states;
  for (size_t i = 0; i < scene.muscles.size(); ++i) {
    if (rows[i].size() == 0) continue;
    in_contact.push_back(i);
    models.push_back(&scene.muscles[i].model);
    targets.push_back(TargetOf(*models.back(), pose, pre_rotation));
    targets.back().one_sided = std::move(rows[i]);
    states.push_back(std::move(start[i]));
  }
  SolvedPose solved = free;
  std::vector<SolverSummary> summaries;
  const Stopwatch solving;
  solver(models, targets, nullptr, &states, &summaries);
  solved.solve_ms += solving.Milliseconds();
  for (size_t k = 0; k < in_contact.size(); ++k) {
    solved.states[in_contact[k]] = std::move(states[k]);
    const SolverSummary& without = free.summaries[in_contact[k]];
    SolverSummary& summary = solved.summaries[in_contact[k]];
    summary = MergedSummary(without, std::move(summaries[k]));
    if (!without.IsSolutionUsable()) {
      summary.stop_reason = without.stop_reason;
      summary.message = without.message;
    }
  }
  return solved;
}

}  // namespace musclewarp
