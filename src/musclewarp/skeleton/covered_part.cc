// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/skeleton/covered_part.h"

#include <glog/logging.h>

#include <algorithm>

#include "musclewarp/base/infinity.h"
#include "musclewarp/skeleton/polyline.h"

namespace musclewarp {
namespace {

// The ends of a line of a model may lie so far beyond a mesh that is somewhat
// too short, mm.
constexpr double kReach = 15;

// Returns where a place lies along its line, mm from the beginning. `along`
// (#P): where the points of the line lie.
double LengthTo(const SegmentPoint& place, const Eigen::VectorXd& along) {
  return (1 - place.t) * along[place.segment] +
         place.t * along[place.segment + 1];
}

// Returns how far along a polyline its points lie, #P, mm.
Eigen::VectorXd LengthsAlong(const Points& line) {
  return PolylineLength(line) * SharesAlong(line);
}

}  // namespace

CoveredPart PartAlong(const Points& line, const Points& muscle) {
  CHECK_GE(line.rows(), 2);
  CHECK_GT(muscle.rows(), 0);
  const std::vector<ActionLine> alone = {{"", line, {}}};
  const Eigen::VectorXd along = LengthsAlong(line);
  CoveredPart part{kInfinity, 0, along[along.size() - 1]};
  for (Eigen::Index v = 0; v < muscle.rows(); ++v) {
    const double here = LengthTo(NearestSegment(muscle.row(v), alone), along);
    part.begin = std::min(part.begin, here);
    part.end = std::max(part.end, here);
  }
  return part;
}

std::vector<SegmentPoint> SamplesAlong(const std::vector<SegmentPoint>& samples,
                                       const std::vector<ActionLine>& lines,
                                       const Points& muscle) {
  std::vector<SegmentPoint> along;
  for (auto begin = samples.begin(); begin != samples.end();) {
    const auto end = std::find_if(begin, samples.end(), [&](const auto& other) {
      return other.line != begin->line;
    });
    const Points& line = lines[begin->line].rest;
    const CoveredPart part = PartAlong(line, muscle);
    const Eigen::VectorXd along_line = LengthsAlong(line);
    std::vector<SegmentPoint> kept;
    std::copy_if(
        begin, end, std::back_inserter(kept), [&](const SegmentPoint& sample) {
          const double here = LengthTo(sample, along_line);
          return here >= part.begin - kReach && here <= part.end + kReach;
        });
    if (kept.size() < 2) kept.assign(begin, end);
    along.insert(along.end(), kept.begin(), kept.end());
    begin = end;
  }
  return along;
}

}  // namespace musclewarp
