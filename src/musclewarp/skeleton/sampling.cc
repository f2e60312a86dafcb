// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/skeleton/sampling.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>

namespace musclewarp {

std::vector<SegmentPoint> SampleLines(const std::vector<ActionLine>& lines,
                                      double spacing) {
  CHECK_GT(spacing, 0);
  std::vector<SegmentPoint> samples;
  for (size_t line = 0; line < lines.size(); ++line) {
    const Points& rest = lines[line].rest;
    for (Eigen::Index s = 0; s + 1 < rest.rows(); ++s) {
      const double length = (rest.row(s + 1) - rest.row(s)).norm();
      const int pieces =
          std::max(1, static_cast<int>(std::ceil(length / spacing)));
      for (int i = s == 0 ? 0 : 1; i <= pieces; ++i) {
        samples.push_back({static_cast<int>(line),
                           static_cast<int>(s),
                           static_cast<double>(i) / pieces});
      }
    }
  }
  return samples;
}

Eigen::RowVector3d PointOnSegment(const Points& polyline,
                                  const SegmentPoint& place) {
  return (1 - place.t) * polyline.row(place.segment) +
         place.t * polyline.row(place.segment + 1);
}

}  // namespace musclewarp
