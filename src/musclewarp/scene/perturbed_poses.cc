// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/perturbed_poses.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "musclewarp/mesh/transformed.h"

namespace musclewarp {
namespace {

ScenePose PoseAside(const ModelPoses& poses,
                    const ScenePose& pose,
                    int coordinate,
                    double step) {
  CoordinateValues values = pose.model_values;
  values[coordinate] += step;
  ApplyCouplers(poses.model, &values);
  return PoseAt(poses, values);
}

}  // namespace

std::vector<int> MomentArmCoordinates(const ModelPoses& poses) {
  std::vector<int> coordinates = FreeCoordinates(poses.model);
  coordinates.insert(coordinates.end(),
                     poses.moving_coordinates.begin(),
                     poses.moving_coordinates.end());
  std::sort(coordinates.begin(), coordinates.end());
  coordinates.erase(std::unique(coordinates.begin(), coordinates.end()),
                    coordinates.end());
  return coordinates;
}

std::vector<PerturbedPoses> PerturbedPosesOf(const ModelPoses& poses,
                                             const ScenePose& pose) {
  std::vector<PerturbedPoses> all;
  for (const int coordinate : MomentArmCoordinates(poses)) {
    all.push_back({coordinate,
                   poses.model.coordinates[coordinate].name,
                   PoseAside(poses, pose, coordinate, -PerturbedPoses::kStep),
                   PoseAside(poses, pose, coordinate, PerturbedPoses::kStep)});
  }
  return all;
}

Eigen::Matrix4d RateBetween(const Eigen::Matrix4d& before,
                            const Eigen::Matrix4d& after) {
  // The logarithm of the motion from before to after, so that bodies that move
  // together have the same rate up to rounding. The omitted terms of the series
  // are far below rounding.
  const Eigen::Matrix4d moved = after * RigidInverse(before);
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(moved.topLeftCorner<3, 3>()));
  const Eigen::Vector3d angles = turn.angle() * turn.axis();
  Eigen::Matrix3d cross;
  cross << 0, -angles.z(), angles.y(),  //
      angles.z(), 0, -angles.x(),       //
      -angles.y(), angles.x(), 0;
  Eigen::Matrix4d rate = Eigen::Matrix4d::Zero();
  rate.topLeftCorner<3, 3>() = cross;
  rate.topRightCorner<3, 1>() =
      (Eigen::Matrix3d::Identity() - cross / 2 + cross * cross / 12) *
      moved.topRightCorner<3, 1>();
  rate /= 2 * PerturbedPoses::kStep;
  return rate;
}

}  // namespace musclewarp
