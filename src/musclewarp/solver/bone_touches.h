// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/scene/scene_pose.h"
#include "musclewarp/solver/bone_push.h"

namespace musclewarp {

// A sample of a muscle near a bone, in a pose.
struct BoneTouch {
  int sample = 0;
  int bone = 0;  // index into BonePush::bones

  // What it lacks of the distance that it keeps, c - d, mm; below zero if it
  // does not touch.
  double lack = 0;

  // The gradient of the distance and its second derivatives, as the pose has
  // them.
  Eigen::RowVector3d normal = Eigen::RowVector3d::Zero();
  Eigen::Matrix3d curvature = Eigen::Matrix3d::Zero();
};

// k phi of BonePush, and its derivatives: energy, force and stiffness of what
// lacks `lack` mm.
struct BoneForce {
  double energy = 0, force = 0, stiffness = 0;
};
BoneForce ForceAt(const BonePush& push, double lack);

// Finds the samples of a muscle that are near bones. Along a way, one that was
// far from a bone is not looked at again before it can have come near.
class BoneTouches {
 public:
  // Keeps a reference to `push`.
  explicit BoneTouches(const BonePush& push);

  // Returns the samples at the given places (S x 3, mm) in a pose that lack
  // more than -margin (mm), by bone and then by sample. What was asked before
  // has no influence on it.
  std::vector<BoneTouch> At(const ScenePose& pose,
                            const Points& places,
                            double margin = 0);

 private:
  // Where the samples were last looked at, as the bone is at rest, and how far
  // from it they were at least, mm.
  struct Seen {
    Points places;           // S x 3
    Eigen::VectorXd bounds;  // S
  };

  const BonePush& push_;
  std::vector<Seen> seen_;  // by bone
};

}  // namespace musclewarp
