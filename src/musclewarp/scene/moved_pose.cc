// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/moved_pose.h"

#include "musclewarp/mesh/transformed.h"

namespace musclewarp {

ScenePose MovedPose(ScenePose pose, const Eigen::Matrix4d& here_from_there) {
  for (auto& body : pose.bodies) body.second = here_from_there * body.second;
  for (auto& line : pose.lines) {
    line.second = Transformed(line.second, here_from_there);
  }
  for (auto& push : pose.pushes) {
    push.second *= here_from_there.topLeftCorner<3, 3>().transpose();
  }
  for (auto& body : pose.taut_lines.bodies) {
    body.second = here_from_there * body.second;
  }
  for (auto& line : pose.taut_lines.points) {
    line.second = Transformed(line.second, here_from_there);
  }
  return pose;
}

}  // namespace musclewarp
