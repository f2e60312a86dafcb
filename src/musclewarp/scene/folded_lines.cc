// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/folded_lines.h"

#include <cmath>
#include <sstream>

#include "musclewarp/base/angles.h"
#include "musclewarp/scene/line_targets.h"
#include "musclewarp/skeleton/polyline.h"

namespace musclewarp {
namespace {

constexpr double kSharpestTurn = RadiansOf(120);  // rad

// Returns true if the scene file could declare the line as sliding: its points
// follow bodies, and the pose gives no target points for it.
bool CouldSlide(const ActionLine& line, const ScenePose& pose) {
  return !line.slides && !line.bodies.empty() &&
         pose.lines.count(line.name) == 0;
}

}  // namespace

std::vector<std::string> FoldedLineWarnings(const Scene& scene) {
  std::vector<std::string> warnings;
  for (const SceneMuscle& muscle : scene.muscles) {
    std::vector<double> sharpest(muscle.lines.size(), kSharpestTurn);
    std::vector<const ScenePose*> folded(muscle.lines.size(), nullptr);
    for (const ScenePose& pose : scene.poses) {
      const std::vector<LineTarget> targets = LineTargets(muscle.lines, pose);
      for (size_t k = 0; k < targets.size(); ++k) {
        const double turn = SharpestTurn(targets[k].points);
        if (turn <= sharpest[k]) continue;
        sharpest[k] = turn;
        folded[k] = &pose;
      }
    }
    for (size_t k = 0; k < muscle.lines.size(); ++k) {
      if (!folded[k]) continue;
      const ActionLine& line = muscle.lines[k];
      std::ostringstream text;
      text << "line " << line.name << " of muscle " << muscle.name
           << " turns back on itself in pose " << folded[k]->name << ", by "
           << std::round(sharpest[k] * kDegreesPerRadian)
           << " degrees from a segment to the next, where the muscle will have "
              "folds: leave out points near the joint";
      if (CouldSlide(line, *folded[k])) {
        text << ", or let the line slide (\"slides\": true)";
      }
      warnings.push_back(text.str());
    }
  }
  return warnings;
}

}  // namespace musclewarp
