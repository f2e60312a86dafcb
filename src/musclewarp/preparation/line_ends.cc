// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/line_ends.h"

#include <map>
#include <utility>

#include "musclewarp/base/text.h"

namespace musclewarp {

std::vector<LineEnd> LineEndsOf(const std::vector<ActionLine>& lines,
                                const std::vector<BodySurface>& bodies) {
  std::vector<LineEnd> ends;
  for (const bool is_first : {true, false}) {
    std::map<std::string, std::pair<double, int>> sums;
    for (const ActionLine& line : lines) {
      if (line.bodies.empty()) continue;
      const int point = is_first ? 0 : static_cast<int>(line.rest.rows()) - 1;
      for (const BodySurface& body : bodies) {
        if (body.body != line.bodies[point] || body.bones.empty()) continue;
        auto& [sum, count] = sums[body.body];
        sum += body.Distance(line.rest.row(point));
        ++count;
      }
    }
    for (const auto& [body, sum] : sums) {
      ends.push_back({body, sum.first / sum.second});
    }
  }
  return ends;
}

std::vector<std::string> FarEndWarnings(const std::string& muscle,
                                        const std::vector<LineEnd>& ends,
                                        double body_size) {
  // A warning that applies to both ends of a muscle is given once.
  std::map<std::string, int> found;
  for (const LineEnd& end : ends) {
    if (end.distance <= kFarEnd) continue;
    ++found[LengthText(end.distance, body_size) + " away from " + end.body];
  }
  std::vector<std::string> warnings;
  for (const auto& [where, count] : found) {
    warnings.push_back(
        (count > 1 ? "both ends of " + muscle + " are " : muscle + " ends ") +
        where + ", to which its lines are fixed, expected at most " +
        LengthText(kFarEnd, body_size) +
        ": it was segmented too short, or ends on another body "
        "(\"end_bodies\" in the scene names them)");
  }
  return warnings;
}

}  // namespace musclewarp
