// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/skeleton/nearest_segment.h"

#include <glog/logging.h>

#include <algorithm>
#include <limits>

namespace musclewarp {

SegmentPoint NearestSegment(const Eigen::RowVector3d& point,
                            const std::vector<ActionLine>& lines) {
  CHECK(!lines.empty());
  SegmentPoint nearest;
  double nearest_squared = std::numeric_limits<double>::infinity();
  for (size_t line = 0; line < lines.size(); ++line) {
    const Points& rest = lines[line].rest;
    for (Eigen::Index s = 0; s + 1 < rest.rows(); ++s) {
      const Eigen::RowVector3d along = rest.row(s + 1) - rest.row(s);
      const double t = std::clamp(
          (point - rest.row(s)).dot(along) / along.squaredNorm(), 0.0, 1.0);
      const double squared = (rest.row(s) + t * along - point).squaredNorm();
      if (squared < nearest_squared) {
        nearest_squared = squared;
        nearest = {static_cast<int>(line), static_cast<int>(s), t};
      }
    }
  }
  return nearest;
}

}  // namespace musclewarp
