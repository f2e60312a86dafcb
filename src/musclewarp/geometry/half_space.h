// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace musclewarp {

// The points p with normal . p >= level.
struct HalfSpace {
  Eigen::RowVector3d normal;  // of unit length
  double level;               // mm
};

// A half-space in which a vertex of a mesh has to stay.
struct VertexHalfSpace {
  int vertex = -1;
  HalfSpace space;
};

}  // namespace musclewarp
