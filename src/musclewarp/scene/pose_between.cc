// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Geometry>
#include <set>

#include "musclewarp/scene/line_targets.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {
namespace {

// Turned evenly about one axis, moved evenly along a line.
Eigen::Matrix4d Between(const Eigen::Matrix4d& from,
                        const Eigen::Matrix4d& to,
                        double part) {
  const Eigen::Quaterniond turn_0(Eigen::Matrix3d(from.topLeftCorner<3, 3>()));
  const Eigen::Quaterniond turn_1(Eigen::Matrix3d(to.topLeftCorner<3, 3>()));
  Eigen::Matrix4d between = (1 - part) * from + part * to;
  between.topLeftCorner<3, 3>() =
      turn_0.slerp(part, turn_1).normalized().toRotationMatrix();
  return between;
}

}  // namespace

ScenePose PoseBetween(const Scene& scene,
                      const ScenePose& from,
                      const ScenePose& to,
                      double part) {
  if (scene.model) {
    CoordinateValues values = from.model_values;
    for (size_t i = 0; i < values.size(); ++i) {
      values[i] += part * (to.model_values[i] - values[i]);
    }
    ApplyCouplers(scene.model->model, &values);
    return PoseAt(*scene.model, values);
  }
  ScenePose pose;
  std::set<std::string> bodies;
  for (const auto& item : from.bodies) bodies.insert(item.first);
  for (const auto& item : to.bodies) bodies.insert(item.first);
  for (const std::string& body : bodies) {
    pose.bodies[body] =
        Between(BodyTransform(from, body), BodyTransform(to, body), part);
  }
  // Lines that neither pose names move with their bodies.
  for (const SceneMuscle& muscle : scene.muscles) {
    const auto targets_0 = LineTargets(muscle.lines, from);
    const auto targets_1 = LineTargets(muscle.lines, to);
    for (size_t i = 0; i < muscle.lines.size(); ++i) {
      const std::string& name = muscle.lines[i].name;
      if (!from.lines.count(name) && !to.lines.count(name)) continue;
      pose.lines[name] =
          (1 - part) * targets_0[i].points + part * targets_1[i].points;
    }
  }
  return pose;
}

ScenePose RestPose(const Scene& scene) {
  if (!scene.model) return ScenePose();
  return PoseAt(*scene.model, scene.model->rest);
}

}  // namespace musclewarp
