// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/way_from_rest.h"

#include <algorithm>
#include <string>

#include "musclewarp/base/angles.h"
#include "musclewarp/base/parallel_for.h"
#include "musclewarp/mesh/transformed.h"
#include "musclewarp/motion/pose_steps.h"
#include "musclewarp/scene/line_targets.h"
#include "musclewarp/scene/moved_pose.h"

namespace musclewarp {
namespace {

// Names the bodies that do not move, too, so that they can be seen from another
// one.
ScenePose WithAllBodies(const std::vector<std::string>& bodies,
                        ScenePose pose) {
  for (const std::string& body : bodies) {
    pose.bodies.emplace(body, Eigen::Matrix4d::Identity());
  }
  return pose;
}

}  // namespace

std::vector<ScenePose> WayFromRest(const Scene& scene, const ScenePose& pose) {
  const StepLimits kLimits = {RadiansOf(20), 40};
  constexpr int kMostSteps = 24;
  const std::vector<std::string> bodies = BodiesInUse(scene);
  const std::string body = bodies.empty() ? "" : bodies[0];
  const Eigen::Matrix4d here = BodyTransform(pose, body);
  const ScenePose rest =
      WithTautLines(scene, WithAllBodies(bodies, RestPose(scene)));
  const ScenePose seen =
      MovedPose(WithAllBodies(bodies, pose),
                BodyTransform(rest, body) * RigidInverse(here));
  const int steps =
      std::min(StepsBetween(scene, rest, seen, kLimits), kMostSteps);
  const auto from_here = [&](const ScenePose& between) {
    return MovedPose(between,
                     here * RigidInverse(BodyTransform(between, body)));
  };
  std::vector<ScenePose> way(steps + 1);
  way.front() = from_here(rest);
  way.back() = pose;
  ParallelFor(steps - 1, [&](size_t k) {
    const double part = static_cast<double>(k + 1) / steps;
    way[k + 1] = WithTautLines(
        scene,
        from_here(PoseBetween(scene, rest, scene.model ? pose : seen, part)));
  });
  return way;
}

}  // namespace musclewarp
