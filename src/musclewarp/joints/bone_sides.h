// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "musclewarp/anatomy/bone.h"
#include "musclewarp/joints/limb.h"

namespace musclewarp {

// A bone, points on its surface, and what was measured on it.
struct SampledBone {
  Bone bone;
  SurfacePoints surface;
  FemurShape femur;  // of a femur only
};

// Returns true for bones that exist on both sides of the body.
bool HasSide(BoneKind kind);

// Returns false if a femur contradicts the axes of the image: if its upward or
// backward direction is off by more than 45 degrees.
bool AgreeWithImage(const std::vector<SampledBone>& bones,
                    const Eigen::Matrix3d& image_axes);

// Assigns a side to every bone that exists on both sides of the body and has
// none yet: by the shape of a femur, by `otherwise`, by the nearest bone with a
// side, and by its place in the image, in this order. Adds a note for each bone
// whose side does not follow from its name or `otherwise`. Bones that get no
// side become BoneKind::kOther; returns false if there are any.
//
// Throws InputError, which begins with the name of the bone, if the side of a
// femur by its shape is not the one by its name, or by its place in the image.
bool DecideSides(const std::optional<Side>& otherwise,
                 const std::optional<Eigen::Matrix3d>& image_axes,
                 std::vector<SampledBone>* bones,
                 std::vector<std::string>* notes);

}  // namespace musclewarp
