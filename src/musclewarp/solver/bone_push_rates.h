// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/scene/scene_pose.h"
#include "musclewarp/solver/bone_push.h"

namespace musclewarp {

// How what a push depends on changes with a coordinate of the skeleton, by rad
// or m.
struct PushMotion {
  Points free;                         // N x 3, mm: of the shape without it
  std::vector<Eigen::Matrix4d> bones;  // of BonePush::bones (RateBetween)
};

// Differentiates a push implicitly, with respect to several coordinates:
// returns the derivatives of its displacements, N x 3 each, mm. `free`: the
// coarse vertices without it in the pose, `push_now`: the displacements, N x 3,
// mm. The samples that touch stay the same. Where the muscle slips over a bone
// (the equilibrium is barely stable, or not), the slipping motions are left
// out.
std::vector<Points> PushRates(const BonePush& push,
                              const ScenePose& pose,
                              const Points& free,
                              const Points& push_now,
                              const std::vector<PushMotion>& motions);

}  // namespace musclewarp
