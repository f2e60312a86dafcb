// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "musclewarp/anatomy/measured_bone.h"

namespace musclewarp {

// The anatomical directions at a bone, of a body that stands with its palms
// forward and its feet flat, in the frame of the meshes.
struct BoneAxes {
  // Anterior, superior and lateral, in columns, orthonormal. On the right they
  // make a right-handed frame, on the left a left-handed one.
  Eigen::Matrix3d directions = Eigen::Matrix3d::Identity();

  // False if the bones do not tell, and the frame of the image does.
  bool are_from_bones = true;
};

// Finds the directions at bones[bone] from where the bones with known names lie
// from each other, and from the long axes of the long ones: those directions
// that fit best to the bones of a standing adult (Wahba's problem, solved by a
// singular value decomposition). Bones of the same part of the limb count most,
// so that a bent joint in the image does little harm. `side` is that of the
// limb; without it the side is found that fits the bones better. `image` has
// the directions forward, up and right of the frame of the meshes in columns,
// for bones that leave the directions open, such as a femur and a tibia alone.
BoneAxes AxesAt(size_t bone,
                const std::vector<MeasuredBone>& bones,
                const std::optional<Side>& side,
                const Eigen::Matrix3d& image);

}  // namespace musclewarp
