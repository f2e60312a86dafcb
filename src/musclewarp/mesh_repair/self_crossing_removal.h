// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// What was done about triangles of one mesh that cross each other.
struct SelfCrossingRemoval {
  int pairs_before = 0;  // of triangles that cross, by an exact test
  int pairs_after = 0;

  // The vertices of the new mesh that the old one does not have, the mean of
  // their places, and how far they are from the old surface at most, mm.
  int new_vertices = 0;
  Eigen::RowVector3d place = Eigen::RowVector3d::Zero();
  double farthest = 0;
};

// Removes the places where a surface of a mesh, which is one closed manifold or
// several, crosses itself; several surfaces may cross each other. Small patches
// around these places are smoothed or cut out and filled again, more and more
// of their neighbourhood until nothing crosses (remove_self_intersections of
// CGAL). Vertices and triangles elsewhere keep their places and order. If that
// does not help, or would leave the mesh open, the mesh stays as it is and
// `pairs_after` equals `pairs_before`.
SelfCrossingRemoval RemoveSelfCrossings(TriangleSoup* soup);

}  // namespace musclewarp
