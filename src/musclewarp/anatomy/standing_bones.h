// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>

namespace musclewarp {

// Parts of the body within which bones hardly move against each other.
enum class BodyPart {
  kTrunk,
  kPelvis,
  kThigh,
  kShank,
  kFoot,
  kShoulder,
  kUpperArm,
  kForearm,
  kHand,
};

// Where a bone, or a group of bones in one mesh, lies in an adult who stands
// with palms forward.
struct StandingBone {
  const char* bone;  // as in BonePlace
  BodyPart part;

  // The middle of its long axis, mm: lateral is to the side of the bone.
  double anterior, superior, lateral;

  Eigen::Vector3d Middle() const { return {anterior, superior, lateral}; }
};

// Returns the entry of the bone that a mesh is, by its name, or nullptr if the
// table has none.
const StandingBone* FindStandingBone(const std::string& name);

}  // namespace musclewarp
