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

void SplitAlongLongestSide(const Points& centroids,
                           int* begin,
                           int* middle,
                           int* end) {
  Eigen::RowVector3d lower = centroids.row(*begin), upper = lower;
  for (const int* f = begin; f != end; ++f) {
    lower = lower.cwiseMin(centroids.row(*f));
    upper = upper.cwiseMax(centroids.row(*f));
  }
  Eigen::Index axis;
  (upper - lower).maxCoeff(&axis);
  std::nth_element(begin, middle, end, [&](int f, int g) {
    return std::make_pair(centroids(f, axis), f) <
           std::make_pair(centroids(g, axis), g);
  });
}

}  // namespace musclewarp
