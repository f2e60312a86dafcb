// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/convergence_measures.h"

#include <glog/logging.h>

#include <algorithm>
#include <numeric>

#include "musclewarp/frames/surface_deformation.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/mesh/triangle.h"
#include "musclewarp/proximity/triangle_bvh.h"

namespace musclewarp {
namespace {

// Returns the weights of the corners for a point of a triangle. A triangle
// without area has no unique ones: the least squares solution is taken.
Eigen::RowVector3d BarycentricOf(const Eigen::RowVector3d& point,
                                 const Corners& corners) {
  Eigen::Matrix<double, 3, 2> edges;
  edges.col(0) = (corners.row(1) - corners.row(0)).transpose();
  edges.col(1) = (corners.row(2) - corners.row(0)).transpose();
  const Eigen::Vector2d part = edges.colPivHouseholderQr().solve(
      (point - corners.row(0)).transpose().eval());
  return {1 - part[0] - part[1], part[0], part[1]};
}

}  // namespace

SurfacePlaces NearestPlaces(const TriangleSoup& surface, const Points& points) {
  const TriangleBvh bvh(surface.points, surface.triangles);
  SurfacePlaces places;
  places.triangles.resize(points.rows());
  places.barycentric.resize(points.rows(), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const TriangleBvh::Closest closest = bvh.ClosestPoint(points.row(i));
    places.triangles[i] = closest.triangle;
    places.barycentric.row(i) =
        BarycentricOf(closest.point, bvh.corners(closest.triangle));
    places.largest_distance =
        std::max(places.largest_distance, closest.distance);
  }
  return places;
}

Points FieldAt(const SurfacePlaces& places,
               const Triangles& triangles,
               const Points& field) {
  Points values = Points::Zero(places.barycentric.rows(), 3);
  for (Eigen::Index i = 0; i < values.rows(); ++i) {
    for (int corner = 0; corner < 3; ++corner) {
      values.row(i) += places.barycentric(i, corner) *
                       field.row(triangles(places.triangles[i], corner));
    }
  }
  return values;
}

StretchSummary SummariseStretch(const TriangleSoup& rest,
                                const Points& deformed) {
  const Eigen::VectorXd stretch =
      MeasureSurfaceDeformation(rest.points, deformed, rest.triangles, Points(0, 3))
          .largest_stretch;
  const Eigen::VectorXd areas = VertexAreas(rest.points, rest.triangles);
  return {stretch.dot(areas) / areas.sum(),
          WeightedQuantile(stretch, areas, 0.99),
          WeightedQuantile(stretch, areas, 0.999),
          stretch.maxCoeff()};
}

double WeightedQuantile(const Eigen::VectorXd& values,
                        const Eigen::VectorXd& weights,
                        double fraction) {
  CHECK_GT(values.size(), 0);
  CHECK_EQ(values.size(), weights.size());
  std::vector<Eigen::Index> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
    return values[a] < values[b];
  });
  const double wanted = fraction * weights.sum();
  double sum = 0;
  for (const Eigen::Index i : order) {
    sum += weights[i];
    if (sum >= wanted) return values[i];
  }
  return values[order.back()];
}

}  // namespace musclewarp
