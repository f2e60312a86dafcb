// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/skeleton/polyline.h"

#include <glog/logging.h>

#include <algorithm>
#include <vector>

namespace musclewarp {

double PolylineLength(const Points& points) {
  double length = 0;
  for (Eigen::Index i = 0; i + 1 < points.rows(); ++i) {
    length += (points.row(i + 1) - points.row(i)).norm();
  }
  return length;
}

Points Resampled(const Points& points, int count) {
  CHECK_GE(points.rows(), 2);
  CHECK_GE(count, 2);
  std::vector<double> along = {0};
  for (Eigen::Index i = 0; i + 1 < points.rows(); ++i) {
    along.push_back(along.back() + (points.row(i + 1) - points.row(i)).norm());
  }
  Points samples(count, 3);
  for (int i = 0; i < count; ++i) {
    const double at = along.back() * i / (count - 1);
    const auto above = std::upper_bound(along.begin() + 1, along.end() - 1, at);
    const Eigen::Index k = above - along.begin() - 1;
    const double width = along[k + 1] - along[k];
    const double t = width > 0 ? std::min(1.0, (at - along[k]) / width) : 0;
    samples.row(i) = (1 - t) * points.row(k) + t * points.row(k + 1);
  }
  return samples;
}

}  // namespace musclewarp
