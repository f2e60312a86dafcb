// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/skeleton/sampling.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>

namespace musclewarp {
namespace {

// No segment of a body is as long as this, mm. One that is longer, which is a
// mistake in the data, is cut into no more pieces than this length would be at
// the usual 10 mm, because the work grows with the samples.
constexpr double kLongestSegment = 1e4;
constexpr int kPiecesOfLongest = 1000;

}  // namespace

int NumPieces(double length, double spacing) {
  const double pieces = std::max(1.0, std::ceil(length / spacing));
  if (length <= kLongestSegment) return static_cast<int>(pieces);
  return static_cast<int>(std::min<double>(pieces, kPiecesOfLongest));
}

std::vector<SegmentPoint> SampleLines(const std::vector<ActionLine>& lines,
                                      double spacing) {
  CHECK_GT(spacing, 0);
  std::vector<SegmentPoint> samples;
  for (size_t line = 0; line < lines.size(); ++line) {
    const Points& rest = lines[line].rest;
    for (Eigen::Index s = 0; s + 1 < rest.rows(); ++s) {
      const double length = (rest.row(s + 1) - rest.row(s)).norm();
      const int pieces = NumPieces(length, spacing);
      for (int i = s == 0 ? 0 : 1; i <= pieces; ++i) {
        samples.push_back({static_cast<int>(line),
                           static_cast<int>(s),
                           static_cast<double>(i) / pieces});
      }
    }
  }
  return samples;
}

Eigen::VectorXd SampleLengths(const std::vector<ActionLine>& lines,
                              const std::vector<SegmentPoint>& samples) {
  const auto point = [&](const SegmentPoint& place) {
    return PointOnSegment(lines[place.line].rest, place);
  };
  Eigen::VectorXd lengths = Eigen::VectorXd::Zero(samples.size());
  for (size_t i = 0; i + 1 < samples.size(); ++i) {
    if (samples[i].line != samples[i + 1].line) continue;
    const double half = (point(samples[i + 1]) - point(samples[i])).norm() / 2;
    lengths[i] += half;
    lengths[i + 1] += half;
  }
  return lengths;
}

Eigen::RowVector3d PointOnSegment(const Points& polyline,
                                  const SegmentPoint& place) {
  return (1 - place.t) * polyline.row(place.segment) +
         place.t * polyline.row(place.segment + 1);
}

}  // namespace musclewarp
