// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/pose_steps.h"

#include <algorithm>
#include <cmath>

#include "musclewarp/base/option_check.h"
#include "musclewarp/scene/line_targets.h"

namespace musclewarp {
namespace {

double TurnBetween(const Eigen::Matrix4d& from, const Eigen::Matrix4d& to) {
  const Eigen::Matrix3d turn =
      to.topLeftCorner<3, 3>() * from.topLeftCorner<3, 3>().transpose();
  return std::acos(std::clamp((turn.trace() - 1) / 2, -1.0, 1.0));
}

}  // namespace

bool StepLimits::IsValid(std::string* error) const {
  return OptionCheck("StepLimits", error)
      .IsAbove("max_turn", max_turn, 0)
      .IsAbove("max_move", max_move, 0)
      .is_valid();
}

double WayBetween(const Scene& scene,
                  const ScenePose& from,
                  const ScenePose& to,
                  const StepLimits& limits) {
  double way = 0;
  for (const SceneBone& bone : scene.bones) {
    const double turn = TurnBetween(BodyTransform(from, bone.body),
                                    BodyTransform(to, bone.body));
    way = std::max(way, turn / limits.max_turn);
  }
  for (const SceneMuscle& muscle : scene.muscles) {
    const auto targets_0 = LineTargets(muscle.lines, from);
    const auto targets_1 = LineTargets(muscle.lines, to);
    for (size_t i = 0; i < targets_0.size(); ++i) {
      const double move = (targets_1[i].points - targets_0[i].points)
                              .rowwise()
                              .norm()
                              .maxCoeff();
      way = std::max(way, move / limits.max_move);
    }
  }
  return way;
}

int StepsBetween(const Scene& scene,
                 const ScenePose& from,
                 const ScenePose& to,
                 const StepLimits& limits) {
  return static_cast<int>(
      std::ceil(std::clamp(WayBetween(scene, from, to, limits), 1.0, 1e9)));
}

}  // namespace musclewarp
