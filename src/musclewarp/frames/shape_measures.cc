// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frames/shape_measures.h"

#include "musclewarp/base/angles.h"
#include "musclewarp/frames/triangle_stretch.h"
#include "musclewarp/geometry/surface_deformation.h"

namespace musclewarp {
namespace {

// Returns the largest value, and sets *place to where it is.
double Largest(const Eigen::VectorXd& values,
               const Points& points,
               Eigen::RowVector3d* place) {
  Eigen::Index where = 0;
  const double largest = values.maxCoeff(&where);
  *place = points.row(where);
  return largest;
}

}  // namespace

ShapeMeasures MeasureShape(const SurfaceAtRest& rest,
                           const Points& points,
                           const Points& before) {
  const SurfaceDeformation deformation = rest.Measure(points);
  ShapeMeasures shape;
  shape.max_stretch =
      Largest(deformation.largest_stretch, points, &shape.stretch_place);
  shape.max_stretch_along = deformation.stretch_along.maxCoeff();
  shape.max_stretch_across = deformation.stretch_across.maxCoeff();
  shape.triangles = MeasureStretch(rest.points(), points, rest.triangles());
  shape.min_area_ratio = deformation.area_ratio.minCoeff();
  shape.max_area_ratio = deformation.area_ratio.maxCoeff();
  shape.max_bend =
      DegreesOf(Largest(deformation.bend, points, &shape.bend_place));
  if (before.rows() == points.rows()) {
    shape.max_change = Largest(
        (points - before).rowwise().norm(), points, &shape.change_place);
  }
  return shape;
}

}  // namespace musclewarp
