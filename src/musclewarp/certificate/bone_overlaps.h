// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "musclewarp/certificate/scene_intersections.h"

namespace musclewarp {

// Two bones of different bodies that lie in each other in a pose, because the
// pose moves them there or because they were delivered like that. Muscles
// between them have no room there, whatever contact does: they are squeezed, or
// leave the bone that they are attached to.
struct BoneOverlap {
  std::string a;
  std::string b;
  double depth_mm = 0;  // of the deepest vertex of one in the other

  // The deepest vertex, mm.
  Eigen::RowVector3d place = Eigen::RowVector3d::Zero();
};

// Returns the pairs of bones of two bodies of which one has a vertex in the
// other, in scene order. `bodies`: by bone. Bones of one body lie as they were
// delivered in every pose and are not looked at. Precondition (CHECKed): every
// bone has a body.
std::vector<BoneOverlap> BoneOverlaps(const std::vector<NamedMesh>& bones,
                                      const std::vector<std::string>& bodies);

}  // namespace musclewarp
