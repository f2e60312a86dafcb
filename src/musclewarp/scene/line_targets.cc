// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/line_targets.h"

#include <algorithm>
#include <utility>

#include "musclewarp/base/parallel_for.h"
#include "musclewarp/skeleton/polyline.h"
#include "musclewarp/skeleton/taut_lines.h"

namespace musclewarp {
namespace {

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

// Returns the target points of a sliding line that is not taut. Points near a
// joint move with the bodies on both sides of it: if each moved with only one,
// the line would fold back on itself where the joint closes.
Points GuidedPoints(const ActionLine& line, const PointMotions& transforms) {
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

// Returns the motions of the points of each line, none where it has no bodies.
std::vector<PointMotions> MotionsOf(const std::vector<ActionLine>& lines,
                                    const ScenePose& pose) {
  std::vector<PointMotions> motions(lines.size());
  for (size_t k = 0; k < lines.size(); ++k) {
    for (const std::string& body : lines[k].bodies) {
      motions[k].push_back(BodyTransform(pose, body));
    }
  }
  return motions;
}

// Returns the points of the taut lines of a muscle, and none for the others:
// those that the pose has for its bodies, or solved.
std::vector<Points> TautPointsIn(const std::vector<ActionLine>& lines,
                                 const ScenePose& pose,
                                 const std::vector<PointMotions>& motions) {
  const auto& solved = pose.taut_lines.points;
  const bool has_all =
      !solved.empty() && pose.taut_lines.bodies == pose.bodies &&
      std::all_of(lines.begin(), lines.end(), [&](const ActionLine& line) {
        return !line.supports || solved.count(line.name) > 0;
      });
  if (!has_all) return TautPoints(lines, motions);
  std::vector<Points> points(lines.size());
  for (size_t k = 0; k < lines.size(); ++k) {
    if (lines[k].supports) points[k] = solved.at(lines[k].name);
  }
  return points;
}

LineTarget TargetOf(const ActionLine& line,
                    const ScenePose& pose,
                    const PointMotions& motions,
                    Points taut) {
  LineTarget target;
  for (const Eigen::Matrix4d& motion : motions) {
    target.body_rotations.push_back(
        Eigen::Matrix3d(motion.topLeftCorner<3, 3>()));
  }
  const auto given = pose.lines.find(line.name);
  if (given != pose.lines.end()) {
    target.points = given->second;
  } else if (line.supports) {
    target.points = std::move(taut);
  } else if (line.slides && !motions.empty()) {
    target.points = GuidedPoints(line, motions);
  } else {
    target.points = line.rest;
    for (size_t i = 0; i < motions.size(); ++i) {
      target.points.row(i) = Transformed(line.rest.row(i), motions[i]);
    }
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
  const std::vector<PointMotions> motions = MotionsOf(lines, pose);
  const bool solves =
      std::any_of(lines.begin(), lines.end(), [&](const ActionLine& line) {
        return line.supports && pose.lines.count(line.name) == 0;
      });
  std::vector<Points> taut(lines.size());
  if (solves) taut = TautPointsIn(lines, pose, motions);
  std::vector<LineTarget> targets;
  for (size_t k = 0; k < lines.size(); ++k) {
    targets.push_back(TargetOf(lines[k], pose, motions[k], std::move(taut[k])));
  }
  return targets;
}

ScenePose WithTautLines(const Scene& scene, ScenePose pose) {
  std::vector<std::vector<Points>> points(scene.muscles.size());
  pose.taut_lines = {};
  ParallelFor(scene.muscles.size(), [&](size_t m) {
    const std::vector<ActionLine>& lines = scene.muscles[m].lines;
    points[m] = TautPoints(lines, MotionsOf(lines, pose));
  });
  pose.taut_lines.bodies = pose.bodies;
  for (size_t m = 0; m < points.size(); ++m) {
    for (size_t k = 0; k < points[m].size(); ++k) {
      const ActionLine& line = scene.muscles[m].lines[k];
      if (!line.supports) continue;
      pose.taut_lines.points[line.name] = std::move(points[m][k]);
    }
  }
  return pose;
}

void SetTautLines(const std::vector<ActionLine>& lines,
                  const ScenePose& pose,
                  std::vector<PerturbedPoses>* beside) {
  const std::vector<PointMotions> motions = MotionsOf(lines, pose);
  const std::vector<Points> points = TautPointsIn(lines, pose, motions);
  for (PerturbedPoses& poses : *beside) {
    std::vector<PointMotions> rates(lines.size());
    for (size_t k = 0; k < lines.size(); ++k) {
      for (const std::string& body : lines[k].bodies) {
        rates[k].push_back(RateBetween(BodyTransform(poses.before, body),
                                       BodyTransform(poses.after, body)));
      }
    }
    const std::vector<Points> velocities =
        TautRates(lines, motions, points, rates);
    for (size_t k = 0; k < lines.size(); ++k) {
      if (!lines[k].supports || pose.lines.count(lines[k].name) > 0) continue;
      // As the first body sees it, so that a line moves along with all of its
      // bodies exactly.
      const std::string& body = lines[k].bodies[0];
      const Eigen::Matrix4d back = RigidInverse(BodyTransform(pose, body));
      const Points seen = velocities[k] - (points[k].rowwise().homogeneous() *
                                           rates[k][0].transpose())
                                              .leftCols<3>();
      for (const double side : {-1.0, 1.0}) {
        ScenePose& there = side < 0 ? poses.before : poses.after;
        there.lines[lines[k].name] =
            Transformed(points[k] + side * PerturbedPoses::kStep * seen,
                        BodyTransform(there, body) * back);
      }
    }
  }
}

}  // namespace musclewarp
