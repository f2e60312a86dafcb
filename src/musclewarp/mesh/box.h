// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>

#include "musclewarp/mesh/triangle.h"

namespace musclewarp {

// A closed box whose faces are parallel to the axes, mm. Trees of boxes over
// the triangles of a mesh rule out most pairs of triangles before the exact
// tests, so the functions below are called far more often than any other.
struct Box3 {
  std::array<double, 3> lower;
  std::array<double, 3> upper;

  // True if the boxes share a point, be it only on their boundaries.
  bool Overlaps(const Box3& other) const {
    // Without short cuts: six comparisons are cheaper than wrong guesses.
    return (lower[0] <= other.upper[0]) & (lower[1] <= other.upper[1]) &
           (lower[2] <= other.upper[2]) & (upper[0] >= other.lower[0]) &
           (upper[1] >= other.lower[1]) & (upper[2] >= other.lower[2]);
  }

  // True if the point is in the box or on its boundary.
  bool Contains(const Eigen::RowVector3d& p) const {
    return (lower[0] <= p[0]) & (lower[1] <= p[1]) & (lower[2] <= p[2]) &
           (upper[0] >= p[0]) & (upper[1] >= p[1]) & (upper[2] >= p[2]);
  }

  // Returns the squared distance to a point, mm^2; zero if the point is in the
  // box.
  double SquaredDistance(const Eigen::RowVector3d& p) const {
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double gap =
          std::max({lower[axis] - p[axis], p[axis] - upper[axis], 0.0});
      sum += gap * gap;
    }
    return sum;
  }

  // Returns the squared distance to another box, mm^2; zero if they share a
  // point. It is a lower bound of the squared distance of whatever the boxes
  // contain.
  double SquaredDistance(const Box3& other) const {
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double gap = std::max({lower[axis] - other.upper[axis],
                                   other.lower[axis] - upper[axis],
                                   0.0});
      sum += gap * gap;
    }
    return sum;
  }
};

// Returns the smallest box that contains a triangle, grown by `margin` (mm) on
// all sides.
inline Box3 BoxOf(const Corners& triangle, double margin = 0) {
  Box3 box;
  for (int axis = 0; axis < 3; ++axis) {
    box.lower[axis] = triangle.col(axis).minCoeff() - margin;
    box.upper[axis] = triangle.col(axis).maxCoeff() + margin;
  }
  return box;
}

// Returns the smallest box that contains points (#P x 3). Precondition: there
// are some.
inline Box3 BoxOf(const Points& points) {
  Box3 box;
  for (int axis = 0; axis < 3; ++axis) {
    box.lower[axis] = points.col(axis).minCoeff();
    box.upper[axis] = points.col(axis).maxCoeff();
  }
  return box;
}

// Returns the smallest box that contains two others.
inline Box3 BoxOf(const Box3& a, const Box3& b) {
  Box3 box;
  for (int axis = 0; axis < 3; ++axis) {
    box.lower[axis] = std::min(a.lower[axis], b.lower[axis]);
    box.upper[axis] = std::max(a.upper[axis], b.upper[axis]);
  }
  return box;
}

}  // namespace musclewarp
