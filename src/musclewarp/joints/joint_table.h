// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "musclewarp/anatomy/bone.h"

namespace musclewarp {

// The joints that are found on bones.
enum class JointKind {
  kHip,
  kKnee,
  kPatella,
  kAnkle,
  kSubtalar,
  kShoulder,
  kElbow,
  kForearm,
};

// A coordinate of a joint: a turn about an axis of its frames, of which x is
// forward, y up and z to the right of the body.
struct JointCoordinate {
  std::string name;  // with the suffix of the side

  // The axis about which positive values turn the child, of unit length. On the
  // left it has x and y reversed, so that the same value is the mirrored
  // motion.
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();

  double lowest = 0, highest = 0;  // the usual range, degrees
};

// Returns all kinds, from the trunk outwards: a body is the child of a joint
// before it is the parent of another.
const std::vector<JointKind>& AllJointKinds();

// "hip", "knee", "patella", ...: the names of --joints.
std::string ToString(JointKind kind);

// Returns the name of a joint of one side: "hip_r".
std::string JointName(JointKind kind, Side side);

// Returns the bodies that a joint connects: "pelvis" and "femur_r".
std::string ParentBody(JointKind kind, Side side);
std::string ChildBody(JointKind kind, Side side);

// Returns the coordinates of a joint, in the order in which they turn.
std::vector<JointCoordinate> CoordinatesOf(JointKind kind, Side side);

// Returns the body to which a bone of a kind belongs, such as "tibia_r" for a
// tibia and a fibula, or an empty text for BoneKind::kOther.
std::string BodyOf(BoneKind kind, Side side);

}  // namespace musclewarp
