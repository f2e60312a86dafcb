// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frames/shape_measures.h"

#include <cmath>

#include "musclewarp/frames/surface_deformation.h"
#include "musclewarp/skeleton/nearest_segment.h"

namespace musclewarp {
namespace {

// Returns the direction of the nearest line at every fine vertex at rest, or of
// the axis along which the muscle is longest if it has no lines.
Points CourseOf(const MuscleModel& model) {
  Points course = Points::Zero(model.fine_rest.rows(), 3);
  if (!model.HasLines()) {
    Eigen::Index axis;
    (model.fine_rest.colwise().maxCoeff() -
     model.fine_rest.colwise().minCoeff())
        .maxCoeff(&axis);
    course.col(axis).setOnes();
    return course;
  }
  for (Eigen::Index i = 0; i < course.rows(); ++i) {
    const SegmentPoint place =
        NearestSegment(model.fine_rest.row(i), model.lines);
    const Points& line = model.lines[place.line].rest;
    course.row(i) = line.row(place.segment + 1) - line.row(place.segment);
  }
  return course;
}

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

ShapeMeasures MeasureShape(const MuscleModel& model,
                           const Points& points,
                           const Points& before) {
  const SurfaceDeformation deformation = MeasureSurfaceDeformation(
      model.fine_rest, points, model.fine_triangles, CourseOf(model));
  ShapeMeasures shape;
  shape.max_stretch =
      Largest(deformation.largest_stretch, points, &shape.stretch_place);
  shape.max_stretch_along = deformation.stretch_along.maxCoeff();
  shape.max_stretch_across = deformation.stretch_across.maxCoeff();
  shape.triangles =
      MeasureStretch(model.fine_rest, points, model.fine_triangles);
  shape.min_area_ratio = deformation.area_ratio.minCoeff();
  shape.max_area_ratio = deformation.area_ratio.maxCoeff();
  shape.max_bend =
      Largest(deformation.bend, points, &shape.bend_place) * 180 / M_PI;
  if (before.rows() == points.rows()) {
    shape.max_change = Largest(
        (points - before).rowwise().norm(), points, &shape.change_place);
  }
  return shape;
}

}  // namespace musclewarp
