// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/skeleton/segment_rotation.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

namespace musclewarp {
namespace {

// Products of a few rotations: rounding of some 1e-15.
constexpr double kRotationRounding = 1e-13;

Eigen::Matrix3d Rotation(double angle, const Eigen::Vector3d& axis) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

ActionLine StraightLine() {
  ActionLine line;
  line.rest.resize(2, 3);
  line.rest << 1, 2, 3, 4, -5, 60;
  line.bodies = {"pelvis", "femur"};
  return line;
}

// The line with its ends moved by a rotation each.
LineTarget Target(const ActionLine& line,
                  const Eigen::Matrix3d& begin,
                  const Eigen::Matrix3d& end) {
  LineTarget target;
  target.points.resize(2, 3);
  target.points.row(0) = line.rest.row(0) * begin.transpose();
  target.points.row(1) = line.rest.row(1) * end.transpose();
  target.body_rotations = {begin, end};
  return target;
}

}  // namespace

TEST(SmallestRotation, TurnsOneDirectionIntoTheOther) {
  // Nearly opposite directions lose digits, since their cross product is small.
  constexpr double kOpposite = 1e-11;
  // AngleAxis takes an arc cosine, which loses half of the digits near 0 and
  // pi.
  constexpr double kArcCosine = 1e-7;
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector3d a(uniform(engine), uniform(engine), uniform(engine));
    const Eigen::Vector3d b(uniform(engine), uniform(engine), uniform(engine));
    const Eigen::Matrix3d r = SmallestRotation(3 * a, b);
    EXPECT_LT((r * a.normalized() - b.normalized()).norm(), kOpposite);
    EXPECT_TRUE((r.transpose() * r).isIdentity(kRotationRounding));
    // Smallest: its angle is that between the directions.
    EXPECT_NEAR(Eigen::AngleAxisd(r).angle(),
                std::atan2(a.cross(b).norm(), a.dot(b)),
                kArcCosine);
  }
}

TEST(SmallestRotation, HandlesEqualOppositeAndZero) {
  const Eigen::Vector3d a(1, 2, 3);
  EXPECT_TRUE(SmallestRotation(a, 5 * a).isIdentity(kRotationRounding));
  // Opposite, and so nearly opposite that the cross product says nothing.
  for (const double off : {0.0, 1e-15, 1e-9, 1e-7}) {
    const Eigen::Vector3d b = -a + off * Eigen::Vector3d(2, -1, 0);
    const Eigen::Matrix3d r = SmallestRotation(a, b);
    EXPECT_LT((r * a.normalized() - b.normalized()).norm(), kRotationRounding);
    EXPECT_TRUE((r.transpose() * r).isIdentity(kRotationRounding));
  }
  EXPECT_TRUE(SmallestRotation(a, Eigen::Vector3d::Zero()).isIdentity(0));
}

TEST(TwistAngle, IsTheAngleAboutTheAxis) {
  const Eigen::Vector3d axis = Eigen::Vector3d(1, -2, 2).normalized();
  for (const double angle : {-3.0, -1.0, 0.0, 0.5, 3.1}) {
    EXPECT_NEAR(
        TwistAngle(Rotation(angle, axis), axis), angle, kRotationRounding);
    // A swing about an axis across adds no twist.
    const Eigen::Vector3d across = axis.cross(Eigen::Vector3d(0, 0, 1));
    EXPECT_NEAR(TwistAngle(Rotation(1, across) * Rotation(angle, axis), axis),
                angle,
                kRotationRounding);
  }
}

TEST(SegmentRotation, OfARigidMotionIsThatMotion) {
  const ActionLine line = StraightLine();
  const Eigen::Matrix3d r = Rotation(2.5, {1, 1, -3});
  for (const double t : {0.0, 0.3, 1.0}) {
    EXPECT_TRUE(SegmentRotation(line, Target(line, r, r), {0, 0, t}, true)
                    .isApprox(r, kRotationRounding));
  }
}

TEST(SegmentRotation, WithoutBodiesLeavesTheTwistOut) {
  const ActionLine line = StraightLine();
  const Eigen::Vector3d direction =
      (line.rest.row(1) - line.rest.row(0)).transpose().normalized();
  LineTarget twisted =
      Target(line, Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Identity());
  twisted.body_rotations = {Rotation(1, direction), Rotation(1, direction)};
  EXPECT_TRUE(SegmentRotation(line, twisted, {0, 0, 0.5}, false)
                  .isIdentity(kRotationRounding));
  EXPECT_TRUE(SegmentRotation(line, twisted, {0, 0, 0.5}, true)
                  .isApprox(Rotation(1, direction), kRotationRounding));
  twisted.body_rotations.clear();
  EXPECT_TRUE(SegmentRotation(line, twisted, {0, 0, 0.5}, true)
                  .isIdentity(kRotationRounding));
}

TEST(SegmentRotation, SpreadsTheTwistEvenlyTheShortWay) {
  const ActionLine line = StraightLine();
  const Eigen::Vector3d direction =
      (line.rest.row(1) - line.rest.row(0)).transpose().normalized();
  LineTarget target;
  target.points = line.rest;
  target.body_rotations = {Rotation(3.0, direction), Rotation(-3.0, direction)};
  // From 3 to -3 through pi: 2 pi - 6 rad, not 6.
  const double turn = 2 * M_PI - 6;
  for (const double t : {0.0, 0.25, 1.0}) {
    EXPECT_TRUE(
        SegmentRotation(line, target, {0, 0, t}, true)
            .isApprox(Rotation(3.0 + t * turn, direction), kRotationRounding));
  }
}

TEST(SegmentRotation, TakesTheKnownEndForBoth) {
  const ActionLine line = StraightLine();
  const Eigen::Vector3d direction =
      (line.rest.row(1) - line.rest.row(0)).transpose().normalized();
  LineTarget target;
  target.points = line.rest;
  target.body_rotations = {std::nullopt, Rotation(0.4, direction)};
  EXPECT_TRUE(SegmentRotation(line, target, {0, 0, 0}, true)
                  .isApprox(Rotation(0.4, direction), kRotationRounding));
}

}  // namespace musclewarp
