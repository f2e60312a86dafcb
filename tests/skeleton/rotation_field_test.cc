// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/skeleton/rotation_field.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

namespace musclewarp {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::RowVector3d;
using Eigen::Vector3d;

// Of products and means of rotations.
constexpr double kTurnRounding = 1e-14;

constexpr double kJointRadius = 10;  // mm

// Two lines side by side, with a joint in the middle of each.
std::vector<ActionLine> JointedLines() {
  std::vector<ActionLine> lines(2);
  for (int i = 0; i < 2; ++i) {
    lines[i].rest.resize(3, 3);
    lines[i].rest << 30 * i, 0, -50, 30 * i, 0, 0, 30 * i, 0, 50;
  }
  return lines;
}

// The upper half of every line turned about its joint.
std::vector<LineTarget> Bent(const std::vector<ActionLine>& lines,
                             double angle) {
  const Matrix3d turn = AngleAxisd(angle, Vector3d::UnitX()).matrix();
  std::vector<LineTarget> targets;
  for (const ActionLine& line : lines) {
    targets.push_back({line.rest, {}});
    Points& points = targets.back().points;
    points.row(2) =
        points.row(1) + (points.row(2) - points.row(1)) * turn.transpose();
  }
  return targets;
}

Points PointsAround(double x, const std::vector<double>& heights) {
  Points points(heights.size(), 3);
  for (size_t i = 0; i < heights.size(); ++i) {
    points.row(i) << x, 8, heights[i];
  }
  return points;
}

double AngleBetween(const Matrix3d& a, const Matrix3d& b) {
  return AngleAxisd(a.transpose() * b).angle();
}

}  // namespace

TEST(RotationField, IsTheRotationOfARigidMotion) {
  const std::vector<ActionLine> lines = JointedLines();
  const Points points = PointsAround(3, {-60, -20, 0, 1, 35});
  const Matrix3d turn =
      AngleAxisd(2.5, Vector3d(1, 2, -3).normalized()).matrix();
  std::vector<LineTarget> targets;
  for (const ActionLine& line : lines) {
    LineTarget target;
    target.points =
        (line.rest * turn.transpose()).rowwise() + RowVector3d(5, 6, 7);
    target.body_rotations.assign(3, turn);
    targets.push_back(target);
  }
  for (const RotationField& field :
       {NearestRotations(points, lines),
        SmoothRotations(points, lines, kJointRadius)}) {
    const auto rotations =
        RotationsOf(field, lines, targets, /*use_body_twist=*/true);
    ASSERT_EQ(rotations.size(), static_cast<size_t>(points.rows()));
    for (const Matrix3d& rotation : rotations) {
      EXPECT_LT((rotation - turn).norm(), kTurnRounding);
    }
  }
}

// Across the joint of a bent line the nearest rotation jumps by the whole
// angle; the smooth one changes as little as one likes.
TEST(RotationField, IsSmoothAcrossAJoint) {
  const std::vector<ActionLine> lines = JointedLines();
  const std::vector<LineTarget> targets = Bent(lines, 1);
  const auto jump = [&](const RotationField& field) {
    const auto rotations = RotationsOf(field, lines, targets, false);
    return AngleBetween(rotations[0], rotations[1]);
  };
  for (const double step : {1.0, 0.1}) {
    const Points beside = PointsAround(3, {-step / 2, step / 2});
    EXPECT_NEAR(jump(NearestRotations(beside, lines)), 1, kTurnRounding);
    // It changes most over a radius or so.
    EXPECT_LT(jump(SmoothRotations(beside, lines, kJointRadius)),
              step / kJointRadius);
  }
}

TEST(RotationField, FarFromAJointIsThatOfTheNearestSegment) {
  const std::vector<ActionLine> lines = JointedLines();
  const std::vector<LineTarget> targets = Bent(lines, 1);
  const Points ends = PointsAround(0, {-50, 50});
  const auto nearest =
      RotationsOf(NearestRotations(ends, lines), lines, targets, false);
  const auto smooth = RotationsOf(
      SmoothRotations(ends, lines, kJointRadius), lines, targets, false);
  for (int i = 0; i < 2; ++i) {
    EXPECT_LT(AngleBetween(nearest[i], smooth[i]), 0.05);
  }
}

TEST(RotationField, DoesNotDependOnTheOrderOfLines) {
  std::vector<ActionLine> lines = JointedLines();
  std::vector<LineTarget> targets = Bent(lines, 0.7);
  targets[1].points.row(2) += RowVector3d(10, 0, -5);
  const Points points = PointsAround(12, {-30, -2, 4, 60});
  const auto rotations = RotationsOf(
      SmoothRotations(points, lines, kJointRadius), lines, targets, false);
  std::swap(lines[0], lines[1]);
  std::swap(targets[0], targets[1]);
  const auto others = RotationsOf(
      SmoothRotations(points, lines, kJointRadius), lines, targets, false);
  for (size_t i = 0; i < rotations.size(); ++i) {
    EXPECT_LT((rotations[i] - others[i]).norm(), kTurnRounding);
  }
}

}  // namespace musclewarp
