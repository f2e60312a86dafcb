// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/proximity/triangle_halves.h"

#include <algorithm>
#include <utility>

namespace musclewarp {

Points CentroidsOf(const Points& points, const Triangles& triangles) {
  Points centroids(triangles.rows(), 3);
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    centroids.row(f) =
        (points.row(triangles(f, 0)) + points.row(triangles(f, 1)) +
         points.row(triangles(f, 2))) /
        3;
  }
  return centroids;
}

void SplitAlongLongestSide(const Points& points,
                           int* begin,
                           int* middle,
                           int* end) {
  Eigen::RowVector3d lower = points.row(*begin), upper = lower;
  for (const int* f = begin; f != end; ++f) {
    lower = lower.cwiseMin(points.row(*f));
    upper = upper.cwiseMax(points.row(*f));
  }
  Eigen::Index axis;
  (upper - lower).maxCoeff(&axis);
  std::nth_element(begin, middle, end, [&](int f, int g) {
    return std::make_pair(points(f, axis), f) <
           std::make_pair(points(g, axis), g);
  });
}

}  // namespace musclewarp
