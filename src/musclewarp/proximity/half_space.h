// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace musclewarp {

// The set of all points p with normal . p >= level: one side of a plane and the
// plane itself. Contact is expressed by such sets, since they are convex: a
// vertex that is in a half-space at both ends of a straight step never leaves
// it in between.
struct HalfSpace {
  Eigen::RowVector3d normal;  // of unit length
  double level;               // signed distance of the plane from 0, mm
};

// A half-space in which one vertex of a mesh has to stay.
struct VertexHalfSpace {
  int vertex = -1;  // index into the vertices of the mesh
  HalfSpace space;
};

}  // namespace musclewarp
