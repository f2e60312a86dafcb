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

}  // namespace musclewarp
