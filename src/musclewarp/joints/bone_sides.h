// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "musclewarp/joints/bone.h"
#include "musclewarp/joints/limb.h"

namespace musclewarp {

// A bone with what its shape tells.
struct SampledBone {
  Bone bone;
  SurfacePoints surface;
  FemurShape femur;  // of a femur only
};

// True for bones that there are on both sides of the body.
bool HasSide(BoneKind kind);

// Returns where forward, up and right are in a frame with such axes ("LPS"), in
// columns. Precondition (CHECKed): the axes are valid, as those of a scene.
Eigen::Matrix3d DirectionsOfAxes(const std::string& axes);

// Returns true if the femora stand in the frame as its axes say, within 45
// degrees, or if there is none that tells.
bool AgreeWithImage(const std::vector<SampledBone>& bones,
                    const Eigen::Matrix3d& image_axes);

// Gives a side to every bone of a kind that has one: by its shape if it is a
// femur without a side, by `otherwise`, by the nearest bone that has one, and
// by its place in the image. Adds a note for each bone that gets its side by
// its place, or gets none; that becomes BoneKind::kOther. Returns false if
// there is such a bone.
//
// Throws InputError, which begins with the name of the bone, if the side of a
// femur by its shape is not the one by its name, or by its place in the image.
bool DecideSides(const std::optional<Side>& otherwise,
                 const std::optional<Eigen::Matrix3d>& image_axes,
                 std::vector<SampledBone>* bones,
                 std::vector<std::string>* notes);

}  // namespace musclewarp
