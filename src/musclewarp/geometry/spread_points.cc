// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/spread_points.h"

#include <limits>

namespace musclewarp {

std::vector<int> SpreadPoints(const Points& points, int count) {
  std::vector<int> taken;
  Eigen::VectorXd distances = Eigen::VectorXd::Constant(
      points.rows(), std::numeric_limits<double>::infinity());
  Eigen::Index next = 0;
  while (static_cast<int>(taken.size()) < count && points.rows() > 0 &&
         distances[next] > 0) {
    taken.push_back(static_cast<int>(next));
    distances = distances.cwiseMin(
        (points.rowwise() - points.row(next)).rowwise().squaredNorm());
    distances.maxCoeff(&next);
  }
  return taken;
}

}  // namespace musclewarp
