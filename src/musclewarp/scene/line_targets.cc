// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/line_targets.h"

#include "musclewarp/skeleton/polyline.h"

namespace musclewarp {
namespace {

using Transforms = std::vector<Eigen::Matrix4d>;

// Returns the weight with which each point of a sliding line (row) moves with
// the body of each point (column), #P x #P: a binomial filter along the line,
// with fixed ends.
Eigen::MatrixXd SharesOfBodies(Eigen::Index count) {
  constexpr int kRounds = 4;
  Eigen::MatrixXd shares = Eigen::MatrixXd::Identity(count, count);
  for (int round = 0; round < kRounds; ++round) {
    const Eigen::MatrixXd before = shares;
    for (Eigen::Index i = 1; i + 1 < count; ++i) {
      shares.row(i) =
          (before.row(i - 1) + 2 * before.row(i) + before.row(i + 1)) / 4;
    }
  }
  return shares;
}

// Returns the target points of a sliding line. Points near a joint move with
// the bodies on both sides of it: if each moved with only one, the line would
// fold back on itself where the joint closes.
Points SlidPoints(const ActionLine& line, const Transforms& transforms) {
  const Eigen::MatrixXd shares = SharesOfBodies(line.rest.rows());
  Points points = Points::Zero(line.rest.rows(), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    for (size_t k = 0; k < transforms.size(); ++k) {
      if (shares(i, k) == 0) continue;
      points.row(i) +=
          shares(i, k) * Transformed(line.rest.row(i), transforms[k]);
    }
  }
  return PointsAtShares(points, SharesAlong(line.rest));
}

LineTarget TargetOf(const ActionLine& line, const ScenePose& pose) {
  LineTarget target;
  target.points = line.rest;
  Transforms transforms;
  for (size_t i = 0; i < line.bodies.size(); ++i) {
    transforms.push_back(BodyTransform(pose, line.bodies[i]));
    target.points.row(i) = Transformed(line.rest.row(i), transforms[i]);
    target.body_rotations.push_back(
        Eigen::Matrix3d(transforms[i].topLeftCorner<3, 3>()));
  }
  const auto given = pose.lines.find(line.name);
  if (given != pose.lines.end()) {
    target.points = given->second;
  } else if (line.slides && !transforms.empty()) {
    target.points = SlidPoints(line, transforms);
  }
  return target;
}

}  // namespace

Eigen::Matrix4d BodyTransform(const ScenePose& pose, const std::string& body) {
  const auto transform = pose.bodies.find(body);
  if (transform == pose.bodies.end()) return Eigen::Matrix4d::Identity();
  return transform->second;
}

std::vector<LineTarget> LineTargets(const std::vector<ActionLine>& lines,
                                    const ScenePose& pose) {
  std::vector<LineTarget> targets;
  for (const auto& line : lines) targets.push_back(TargetOf(line, pose));
  return targets;
}

}  // namespace musclewarp
