// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/proximity/half_space.h"

namespace musclewarp {

// What a plane goes along with: a bone, or two triangles, one of a muscle above
// it and one of a muscle below, which may be the same.
struct PlaneOwner {
  int bone = -1;  // or -1

  int muscle_above = -1, muscle_below = -1;
  Eigen::RowVector3i above, below;  // vertices

  // How much the side above decides on the place of the plane (0 to 1).
  double share_above = 0.5;

  bool IsBone() const { return bone >= 0; }
};

// Half-spaces of vertices of a muscle, and what the plane of each goes along
// with.
struct OwnedHalfSpaces {
  std::vector<VertexHalfSpace> spaces;
  std::vector<PlaneOwner> owners;
};

}  // namespace musclewarp
