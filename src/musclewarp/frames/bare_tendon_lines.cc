// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frames/bare_tendon_lines.h"

#include <algorithm>

#include "musclewarp/scene/line_targets.h"
#include "musclewarp/skeleton/polyline.h"

namespace musclewarp {

std::vector<Points> BareTendonLines(const std::vector<ActionLine>& lines,
                                    const ScenePose* pose) {
  const bool has_any =
      std::any_of(lines.begin(), lines.end(), [](const ActionLine& line) {
        return line.bare_begin + line.bare_end > 0;
      });
  if (!has_any) return {};
  std::vector<LineTarget> targets;
  if (pose) targets = LineTargets(lines, *pose);
  std::vector<Points> tendons;
  for (size_t i = 0; i < lines.size(); ++i) {
    const ActionLine& line = lines[i];
    const Points& points = pose ? targets[i].points : line.rest;
    // The parts are cut at points of the line, which are the same in each pose.
    const double length = PolylineLength(line.rest);
    const Eigen::ArrayXd along = length * SharesAlong(line.rest).array();
    const Eigen::Index begin = (along <= line.bare_begin).count();
    const Eigen::Index end = (along >= length - line.bare_end).count();
    if (line.bare_begin > 0 && begin > 1) {
      tendons.emplace_back(points.topRows(begin));
    }
    if (line.bare_end > 0 && end > 1) {
      tendons.emplace_back(points.bottomRows(end));
    }
  }
  return tendons;
}

}  // namespace musclewarp
