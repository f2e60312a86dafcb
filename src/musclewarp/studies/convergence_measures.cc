// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/studies/convergence_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "musclewarp/mesh/measures.h"
#include "musclewarp/mesh/triangle.h"
#include "musclewarp/proximity/triangle_bvh.h"
#include "musclewarp/proximity/triangle_distance.h"

namespace musclewarp {
namespace {

// Returns the weights of the corners for a point of a triangle. They are not
// unique for a triangle without area: the least squares solution is returned.
Eigen::RowVector3d BarycentricOf(const Eigen::RowVector3d& point,
                                 const Corners& corners) {
  Eigen::Matrix<double, 3, 2> edges;
  edges.col(0) = (corners.row(1) - corners.row(0)).transpose();
  edges.col(1) = (corners.row(2) - corners.row(0)).transpose();
  const Eigen::Vector2d part = edges.colPivHouseholderQr().solve(
      (point - corners.row(0)).transpose().eval());
  return {1 - part[0] - part[1], part[0], part[1]};
}

// Returns the axes of a triangle in rows: along its first edge, across it, and
// its normal. They are zero where it has no area.
Eigen::Matrix3d FrameOf(const Corners& corners) {
  const Eigen::RowVector3d edge =
      (corners.row(1) - corners.row(0)).normalized();
  const Eigen::RowVector3d normal = AreaVector(corners).normalized();
  Eigen::Matrix3d frame;
  frame << edge, normal.cross(edge), normal;
  return frame;
}

// Returns the nearest point among triangles that face a direction, or among all
// if none does.
TriangleBvh::Closest ClosestFacing(const TriangleBvh& bvh,
                                   const Eigen::RowVector3d& point,
                                   const Eigen::RowVector3d& direction) {
  TriangleBvh::Closest closest;
  double least = std::numeric_limits<double>::infinity();
  bvh.TraverseNearestFirst(
      [&](const Box3& box) { return box.SquaredDistance(point); },
      [&](int triangle) {
        const Corners& corners = bvh.corners(triangle);
        if (!(AreaVector(corners).dot(direction) > 0)) return;
        const Eigen::RowVector3d candidate =
            ClosestPointOfTriangle(point, corners);
        const double square = (point - candidate).squaredNorm();
        if (square >= least) return;
        least = square;
        closest.triangle = triangle;
        closest.point = candidate;
        closest.distance = std::sqrt(square);
      },
      &least);
  return closest.triangle >= 0 ? closest : bvh.ClosestPoint(point);
}

}  // namespace

SurfacePlaces NearestPlaces(const TriangleSoup& surface,
                            const TriangleSoup& from) {
  const TriangleBvh bvh(surface.points, surface.triangles);
  // The area-weighted mean normals of the triangles at each vertex.
  const Points normals = VolumeGradient(from.points, from.triangles);
  const Eigen::Index num_places = from.points.rows();
  SurfacePlaces places;
  places.triangles.resize(num_places);
  places.barycentric.resize(num_places, 3);
  places.offsets.resize(num_places, 3);
  for (Eigen::Index i = 0; i < num_places; ++i) {
    const TriangleBvh::Closest closest =
        ClosestFacing(bvh, from.points.row(i), normals.row(i));
    const Corners& corners = bvh.corners(closest.triangle);
    places.triangles[i] = closest.triangle;
    places.barycentric.row(i) = BarycentricOf(closest.point, corners);
    places.offsets.row(i) =
        (from.points.row(i) - closest.point) * FrameOf(corners).transpose();
    places.largest_distance =
        std::max(places.largest_distance, closest.distance);
  }
  return places;
}

Points CarriedPoints(const SurfacePlaces& places,
                     const Triangles& triangles,
                     const Points& deformed) {
  Points carried(places.barycentric.rows(), 3);
  for (Eigen::Index i = 0; i < carried.rows(); ++i) {
    const Corners corners =
        CornersOf(deformed, triangles.row(places.triangles[i]));
    carried.row(i) = places.barycentric.row(i) * corners +
                     places.offsets.row(i) * FrameOf(corners);
  }
  return carried;
}

}  // namespace musclewarp
