// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/certificate/scene_intersections.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Straight pieces of curves, by the indices of their two ends. Pieces that meet
// share a point.
struct SegmentSoup {
  Points points;  // #P x 3, mm
  Eigen::Matrix<int, Eigen::Dynamic, 2, Eigen::RowMajor> segments;  // #S x 2
};

// A place where two meshes intersect, or one mesh crosses itself: crossing
// triangles that are connected through the triangles they cross or through
// vertices of one mesh inside the other. Two places have neither triangles nor
// such vertices in common.
struct CrossingPlace {
  int a = 0;
  int b = 0;  // as a, if the mesh crosses itself

  // The triangles that cross, ascending; of a mesh that crosses itself, all are
  // in triangles_of_a. Both are empty if one mesh is inside the other.
  std::vector<int> triangles_of_a;
  std::vector<int> triangles_of_b;

  // Where the surfaces cross. A pair of triangles that touch in a point or in a
  // plane has no segment.
  SegmentSoup curve;

  // The vertices of either mesh inside the other, and the distance of the
  // deepest of them from the surface of the other, mm. 0 for a mesh that
  // crosses itself, where nothing is inside.
  int vertices_inside = 0;
  double depth_mm = 0;

  // Where to look, mm: the deepest vertex; without one, the mean of the points
  // of the curve, or of the corners of triangles_of_a if it has none.
  Eigen::RowVector3d point = Eigen::RowVector3d::Zero();
};

// Returns all places where two muscles or a muscle and a bone intersect, or a
// muscle crosses itself. Meshes are numbered muscles first, then bones. Pairs
// of triangles are found by exact tests; the points of curves are rounded.
std::vector<CrossingPlace> FindCrossingPlaces(
    const std::vector<NamedMesh>& muscles, const std::vector<NamedMesh>& bones);

// Returns the length of all pieces, mm.
double CurveLength(const SegmentSoup& curve);

}  // namespace musclewarp
