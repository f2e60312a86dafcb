// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/skeleton/polyline.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace musclewarp {

double PolylineLength(const Points& points) {
  double length = 0;
  for (Eigen::Index i = 0; i + 1 < points.rows(); ++i) {
    length += (points.row(i + 1) - points.row(i)).norm();
  }
  return length;
}

Eigen::VectorXd SharesAlong(const Points& points) {
  Eigen::VectorXd along = Eigen::VectorXd::Zero(points.rows());
  for (Eigen::Index i = 1; i < points.rows(); ++i) {
    along[i] = along[i - 1] + (points.row(i) - points.row(i - 1)).norm();
  }
  const double length = along.size() > 0 ? along[along.size() - 1] : 0;
  if (length > 0) along /= length;
  return along;
}

double SharpestTurn(const Points& points) {
  double sharpest = 0;
  Eigen::RowVector3d before = Eigen::RowVector3d::Zero();
  for (Eigen::Index i = 1; i < points.rows(); ++i) {
    const Eigen::RowVector3d segment = points.row(i) - points.row(i - 1);
    if (segment.norm() == 0) continue;
    const double turn =
        std::atan2(before.cross(segment).norm(), before.dot(segment));
    if (before.norm() > 0) sharpest = std::max(sharpest, turn);
    before = segment;
  }
  return sharpest;
}

Points PointsAtShares(const Points& points, const Eigen::VectorXd& shares) {
  CHECK_GE(points.rows(), 2);
  const Eigen::VectorXd along = SharesAlong(points);
  const double* const first = along.data();
  const double* const last = first + along.size() - 1;
  Points samples(shares.size(), 3);
  for (Eigen::Index i = 0; i < shares.size(); ++i) {
    const Eigen::Index k =
        std::upper_bound(first + 1, last, shares[i]) - first - 1;
    const double width = along[k + 1] - along[k];
    const double t =
        width > 0 ? std::min(1.0, (shares[i] - along[k]) / width) : 0;
    samples.row(i) = (1 - t) * points.row(k) + t * points.row(k + 1);
  }
  return samples;
}

Points Resampled(const Points& points, int count) {
  CHECK_GE(count, 2);
  return PointsAtShares(points, Eigen::VectorXd::LinSpaced(count, 0, 1));
}

}  // namespace musclewarp
