// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/muscle_course.h"

#include "musclewarp/skeleton/nearest_segment.h"

namespace musclewarp {

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

}  // namespace musclewarp
