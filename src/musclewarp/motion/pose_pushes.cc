// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/pose_pushes.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "musclewarp/base/parallel_for.h"
#include "musclewarp/base/stage_times.h"
#include "musclewarp/motion/way_from_rest.h"
#include "musclewarp/preparation/soft_attachments.h"
#include "musclewarp/solver/bone_push.h"

namespace musclewarp {
namespace {

bool IsAnyPushed(const PreparedScene& scene) {
  return std::any_of(scene.muscles.begin(),
                     scene.muscles.end(),
                     [](const PreparedMuscle& muscle) {
                       return muscle.model.bone_push != nullptr;
                     });
}

}  // namespace

ScenePose WithPushes(const PreparedScene& scene,
                     const PreRotationOptions& pre_rotation,
                     ScenePose pose) {
  const ScopedStage stage("push of bones");
  pose.pushes.clear();
  if (!IsAnyPushed(scene)) return pose;
  std::vector<ScenePose> way = WayFromRest(scene.scene, pose);
  for (const auto& group : CarriersFirst(scene)) {
    std::vector<std::vector<Points>> pushes(group.size());
    ParallelFor(group.size(), [&](size_t i) {
      const MuscleModel& model = scene.muscles[group[i]].model;
      if (!model.bone_push) return;
      std::vector<Points> free;
      for (const ScenePose& part : way) {
        free.push_back(
            UnconstrainedMinimizer(model, TargetOf(model, part, pre_rotation)));
      }
      pushes[i] = FollowPush(*model.bone_push, way, free);
    });
    for (size_t i = 0; i < group.size(); ++i) {
      for (size_t k = 0; k < pushes[i].size(); ++k) {
        if (pushes[i][k].isZero(0)) continue;
        way[k].pushes.emplace(scene.muscles[group[i]].model.name,
                              std::move(pushes[i][k]));
      }
    }
  }
  return std::move(way.back());
}

}  // namespace musclewarp
