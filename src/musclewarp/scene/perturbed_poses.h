// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/scene/model_poses.h"

namespace musclewarp {

// The two poses of a model on both sides of a given one, for derivatives with
// respect to a coordinate by central differences. Poses are closed-form
// functions of the coordinates, so that a small step is accurate: lengths of
// 500 mm have a rounding error of 1e-13 mm, which contributes 1e-9 mm/rad, and
// the third derivative contributes about 1e-6 mm/rad.
struct PerturbedPoses {
  // Half the difference of the coordinate between the two poses: rad, or m for
  // a translational coordinate.
  static constexpr double kStep = 1e-4;

  int coordinate = -1;  // index into the model
  std::string name;
  ScenePose before, after;  // at q - kStep and q + kStep
};

// Returns the coordinates for which a scene has moment arms, as ascending
// indices into the model: those that are free, and those that the motion
// changes even if they are not free in the model.
std::vector<int> MomentArmCoordinates(const ModelPoses& poses);

// Returns the perturbed poses around `pose`, a pose of the model, for each of
// these coordinates. Coupled coordinates change along with them.
std::vector<PerturbedPoses> PerturbedPosesOf(const ModelPoses& poses,
                                             const ScenePose& pose);

// Returns the rate of a rigid motion, 4 x 4, from the poses of a body before
// and after (target_from_rest, mm): the matrix that maps a point p of the body,
// in its pose halfway between them, to its velocity rate * (p, 1), mm/rad (or
// mm/m).
Eigen::Matrix4d RateBetween(const Eigen::Matrix4d& before,
                            const Eigen::Matrix4d& after);

}  // namespace musclewarp
