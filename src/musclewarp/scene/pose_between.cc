// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <map>
#include <set>
#include <string>

#include "musclewarp/scene/line_targets.h"
#include "musclewarp/scene/scene.h"
#include "musclewarp/scene/screw_motion.h"

namespace musclewarp {
namespace {

// Returns the motions of the bodies from one pose to another, in target space.
std::map<std::string, ScrewMotion> MotionsOf(const ScenePose& from,
                                             const ScenePose& to) {
  std::set<std::string> bodies;
  for (const auto& item : from.bodies) bodies.insert(item.first);
  for (const auto& item : to.bodies) bodies.insert(item.first);
  std::map<std::string, ScrewMotion> motions;
  for (const std::string& body : bodies) {
    motions.emplace(body,
                    ScrewMotion(BodyTransform(to, body) *
                                RigidInverse(BodyTransform(from, body))));
  }
  return motions;
}

Eigen::Vector3d Moved(const Eigen::Matrix4d& motion, const Eigen::Vector3d& p) {
  return motion.topLeftCorner<3, 3>() * p + motion.topRightCorner<3, 1>();
}

// Returns the share (0 to 1) of a motion that brings p nearest to q.
double ShareOf(const ScrewMotion& motion,
               const Eigen::Vector3d& p,
               const Eigen::Vector3d& q) {
  const auto miss = [&](double share) {
    return (Moved(motion.Part(share), p) - q).squaredNorm();
  };
  // For turns of less than half a circle, the distance has one minimum.
  double low = 0, high = 1;
  for (int step = 0; step < 60; ++step) {
    const double a = low + (high - low) / 3;
    const double b = high - (high - low) / 3;
    (miss(a) < miss(b) ? high : low) = miss(a) < miss(b) ? b : a;
  }
  return (low + high) / 2;
}

// Returns a point on its way from p to q: along the screw motion of a body if a
// share of that motion takes p to q, as half of a joint's rotation does next to
// the joint; otherwise along a straight line.
Eigen::Vector3d PointBetween(const std::map<std::string, ScrewMotion>& motions,
                             const Eigen::Vector3d& p,
                             const Eigen::Vector3d& q,
                             double part) {
  constexpr double kAllowedMiss = 0.1;  // of the way
  double least = kAllowedMiss * (q - p).norm();
  Eigen::Vector3d between = (1 - part) * p + part * q;
  for (const auto& [body, motion] : motions) {
    const double share = ShareOf(motion, p, q);
    const Eigen::Vector3d rest = q - Moved(motion.Part(share), p);
    if (rest.norm() >= least) continue;
    least = rest.norm();
    between = Moved(motion.Part(part * share), p) + part * rest;
  }
  return between;
}

}  // namespace

ScenePose PoseBetween(const Scene& scene,
                      const ScenePose& from,
                      const ScenePose& to,
                      double part) {
  if (scene.model) {
    CoordinateValues values = from.model_values;
    for (size_t i = 0; i < values.size(); ++i) {
      values[i] += part * (to.model_values[i] - values[i]);
    }
    ApplyCouplers(scene.model->model, &values);
    return PoseAt(*scene.model, values);
  }
  ScenePose pose;
  const std::map<std::string, ScrewMotion> motions = MotionsOf(from, to);
  for (const auto& [body, motion] : motions) {
    pose.bodies[body] = motion.Part(part) * BodyTransform(from, body);
  }
  // Lines for which neither pose has targets move with their bodies.
  for (const SceneMuscle& muscle : scene.muscles) {
    const auto targets_0 = LineTargets(muscle.lines, from);
    const auto targets_1 = LineTargets(muscle.lines, to);
    for (size_t i = 0; i < muscle.lines.size(); ++i) {
      const std::string& name = muscle.lines[i].name;
      if (!from.lines.count(name) && !to.lines.count(name)) continue;
      const Points& start = targets_0[i].points;
      const Points& end = targets_1[i].points;
      Points& between = pose.lines[name];
      between.resize(start.rows(), 3);
      for (Eigen::Index k = 0; k < start.rows(); ++k) {
        between.row(k) =
            PointBetween(
                motions, start.row(k).transpose(), end.row(k).transpose(), part)
                .transpose();
      }
    }
  }
  return pose;
}

ScenePose RestPose(const Scene& scene) {
  if (!scene.model) return ScenePose();
  return PoseAt(*scene.model, scene.model->rest);
}

}  // namespace musclewarp
