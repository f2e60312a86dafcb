// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/proximity/half_space.h"

namespace musclewarp {

// The owner of a separating plane, which determines how the plane moves: a
// bone, or two triangles, one of the muscle above and one of the muscle below,
// which may be the same.
struct PlaneOwner {
  int bone = -1;  // -1 between muscles

  int muscle_above = -1, muscle_below = -1;
  Eigen::RowVector3i above, below;  // vertices

  // The weight of the side above in the level of the plane, 0 to 1.
  double share_above = 0.5;

  bool IsBone() const { return bone >= 0; }
};

// Half-spaces of the vertices of a muscle, and the owner of the plane of each.
struct OwnedHalfSpaces {
  std::vector<VertexHalfSpace> spaces;
  std::vector<PlaneOwner> owners;
};

}  // namespace musclewarp
