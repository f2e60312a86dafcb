// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/scene/model_poses.h"

namespace musclewarp {

// The poses of a model on both sides of one of its poses, for derivatives with
// respect to a coordinate by central differences. Poses are exact functions of
// the coordinates in closed form, so that a small step is accurate: lengths of
// 500 mm are rounded by 1e-13 mm, which makes 1e-9 mm/rad, and the third
// derivative adds about 1e-6 mm/rad.
struct PerturbedPoses {
  // Half the distance between the two poses: rad, or m of a translation.
  static constexpr double kStep = 1e-4;

  int coordinate = -1;  // index into the model
  std::string name;
  ScenePose before, after;  // at q - kStep and q + kStep
};

// Returns the coordinates for which a scene has moment arms, by their index in
// the model, in rising order: those that can change on their own, and those
// that the motion moves whatever the model says.
std::vector<int> MomentArmCoordinates(const ModelPoses& poses);

// Returns the poses beside `pose`, a pose of the model, for each of these
// coordinates. Coupled coordinates move along.
std::vector<PerturbedPoses> PerturbedPosesOf(const ModelPoses& poses,
                                             const ScenePose& pose);

// Returns the rate of a rigid motion, 4 x 4, from the places of a body before
// and after: what takes a point p of the body, where the body is in the middle,
// to its velocity, rate * (p, 1), mm/rad (or mm/m).
Eigen::Matrix4d RateBetween(const Eigen::Matrix4d& before,
                            const Eigen::Matrix4d& after);

}  // namespace musclewarp
