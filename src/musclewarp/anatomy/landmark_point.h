// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "musclewarp/anatomy/bone.h"
#include "musclewarp/anatomy/bone_places.h"
#include "musclewarp/anatomy/measured_bone.h"

namespace musclewarp {

// How well a landmark is known.
enum class LandmarkEvidence {
  kFound,    // on its bone, whose directions follow from the bones
  kWeak,     // on a bone that stands in for it, or on a mesh of several bones
  kGuessed,  // the bones do not tell the directions: those of the image
};

std::string ToString(LandmarkEvidence evidence);

// One of the places of a landmark, and the bone that it is on, by index.
struct PlaceOnBone {
  size_t place = 0;
  size_t bone = 0;
};

// Returns the first of the places of a landmark (PlacesOfLandmark) whose bone
// is among `bones`. Only bones of `side` count where both sides are known.
// Nothing is returned if no bone of it is there.
std::optional<PlaceOnBone> FindPlace(const std::vector<BonePlace>& places,
                                     const std::vector<MeasuredBone>& bones,
                                     const std::optional<Side>& side);

// A landmark on the bones of a scene, in the frame of the meshes.
struct LandmarkPoint {
  size_t bone = 0;                                          // index
  Eigen::RowVector3d point = Eigen::RowVector3d::Zero();    // mm
  Eigen::RowVector3d outward = Eigen::RowVector3d::Zero();  // of unit length
  LandmarkEvidence evidence = LandmarkEvidence::kFound;
};

// Finds a landmark on the bone that FindPlace() returns, where it reaches
// farthest to the side that the place names within the named part of its
// length. `image` is as for AxesAt.
std::optional<LandmarkPoint> FindLandmark(
    const std::vector<BonePlace>& places,
    const std::vector<MeasuredBone>& bones,
    const std::optional<Side>& side,
    const Eigen::Matrix3d& image);

}  // namespace musclewarp
