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

// The triangle that decides on which side of a closed mesh a point is.
struct Facing {
  RowVector3d normal = RowVector3d::Zero();  // of unit length

  // The height of the point above the triangle, mm: below 0 inside the mesh.
  double height = 0;
};

// Several triangles may meet at the place that is closest to a point, at
// `distance`, which may be a vertex; the one whose normal is most nearly
// parallel to the direction to the point, or to its opposite, decides.
Facing FacingOf(const TriangleBvh& mesh,
                const RowVector3d& point,
                double distance) {
  const double limit = distance * distance * (1 + kEqual);
  double squarest = -1;
  Facing decisive;
  mesh.Traverse(
      [&](const Box3& box) { return box.SquaredDistance(point) <= limit; },
      [&](int triangle) {
        const Corners& corners = mesh.corners(triangle);
        const RowVector3d way = point - ClosestPointOfTriangle(point, corners);
        const RowVector3d normal = AreaVector(corners);
        const double area = normal.norm();
        if (way.squaredNorm() > limit || area == 0) return;
        const double height = normal.dot(way) / area;
        if (std::abs(height) <= squarest) return;
        squarest = std::abs(height);
        decisive = {normal / area, height};
      });
  return decisive;
}

}  // namespace

PlaceBeside PlaceBesideMeshes(const std::vector<const TriangleBvh*>& meshes,
                              const RowVector3d& point) {
  // Nearer than this the direction to the closest point is rounding, mm.
  constexpr double kOnSurface = 1e-3;
  PlaceBeside place;
  for (const TriangleBvh* mesh : meshes) {
    const TriangleBvh::Closest closest = mesh->ClosestPoint(point);
    if (closest.triangle < 0) continue;
    const Facing facing = FacingOf(*mesh, point, closest.distance);
    const bool is_inside = mesh->box().Contains(point) && facing.height <= 0;
    const double distance = is_inside ? -closest.distance : closest.distance;
    if (distance >= place.distance) continue;
    place.distance = distance;
    place.outward = closest.distance < kOnSurface
                        ? facing.normal
                        : RowVector3d((point - closest.point) / distance);
  }
  return place;
}

double DistanceOutside(const std::vector<const TriangleBvh*>& meshes,
                       const RowVector3d& point) {
  return std::max(0.0, PlaceBesideMeshes(meshes, point).distance);
}

}  // namespace musclewarp
