// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/fibres/distance_outside.h"

#include <algorithm>
#include <cmath>

#include "musclewarp/base/infinity.h"
#include "musclewarp/mesh/triangle.h"
#include "musclewarp/proximity/triangle_distance.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// Squared distances that differ by less than this share are equal.
constexpr double kEqual = 1e-9;

// Returns true if a point is inside a closed mesh or on it. Several triangles
// may meet at the closest point, which may be a vertex; the one whose normal is
// most nearly parallel to the direction to the point, or to its opposite,
// decides.
bool IsInside(const TriangleBvh& mesh,
              const RowVector3d& point,
              double distance) {
  const double limit = distance * distance * (1 + kEqual);
  double squarest = -1;
  bool is_inside = true;
  mesh.Traverse(
      [&](const Box3& box) { return box.SquaredDistance(point) <= limit; },
      [&](int triangle) {
        const Corners& corners = mesh.corners(triangle);
        const RowVector3d way = point - ClosestPointOfTriangle(point, corners);
        const RowVector3d normal = AreaVector(corners);
        const double area = normal.norm();
        if (way.squaredNorm() > limit || area == 0) return;
        const double facing = normal.dot(way) / area;
        if (std::abs(facing) <= squarest) return;
        squarest = std::abs(facing);
        is_inside = facing <= 0;
      });
  return is_inside;
}

}  // namespace

double DistanceOutside(const std::vector<const TriangleBvh*>& meshes,
                       const RowVector3d& point) {
  double distance = kInfinity;
  for (const TriangleBvh* mesh : meshes) {
    const double here = mesh->ClosestPoint(point).distance;
    if (here < kInfinity && mesh->box().Contains(point) &&
        IsInside(*mesh, point, here)) {
      return 0;
    }
    distance = std::min(distance, here);
  }
  return distance;
}

}  // namespace musclewarp
