// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/line_targets.h"

namespace musclewarp {
namespace {

LineTarget TargetOf(const ActionLine& line, const ScenePose& pose) {
  LineTarget target;
  target.points = line.rest;
  for (size_t i = 0; i < line.bodies.size(); ++i) {
    const Eigen::Matrix4d transform = BodyTransform(pose, line.bodies[i]);
    target.points.row(i) = Transformed(line.rest.row(i), transform);
    target.body_rotations.push_back(
        Eigen::Matrix3d(transform.topLeftCorner<3, 3>()));
  }
  const auto given = pose.lines.find(line.name);
  if (given != pose.lines.end()) target.points = given->second;
  return target;
}

}  // namespace

Eigen::Matrix4d BodyTransform(const ScenePose& pose, const std::string& body) {
  const auto transform = pose.bodies.find(body);
  if (transform == pose.bodies.end()) return Eigen::Matrix4d::Identity();
  return transform->second;
}

std::vector<LineTarget> LineTargets(const std::vector<ActionLine>& lines,
                                    const ScenePose& pose) {
  std::vector<LineTarget> targets;
  for (const auto& line : lines) targets.push_back(TargetOf(line, pose));
  return targets;
}

}  // namespace musclewarp
