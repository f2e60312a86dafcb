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
    for (const ActionLine& line : muscle.lines) {
      double sharpest = kSharpestTurn;
      const ScenePose* folded = nullptr;
      for (const ScenePose& pose : scene.poses) {
        const double turn = SharpestTurn(LineTargets({line}, pose)[0].points);
        if (turn <= sharpest) continue;
        sharpest = turn;
        folded = &pose;
      }
      if (!folded) continue;
      std::ostringstream text;
      text << "line " << line.name << " of muscle " << muscle.name
           << " turns back on itself in pose " << folded->name << ", by "
           << std::round(sharpest * kDegreesPerRadian)
           << " degrees from a segment to the next, where the muscle will have "
              "folds: leave out points near the joint";
      if (CouldSlide(line, *folded)) {
        text << ", or let the line slide (\"slides\": true)";
      }
      warnings.push_back(text.str());
    }
  }
  return warnings;
}

}  // namespace musclewarp
