// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/knee.h"

#include <gtest/gtest.h>

#include <cmath>

#include "joints/ideal_surfaces.h"
#include "musclewarp/base/angles.h"
#include "support/made_bones.h"

namespace musclewarp {
namespace {

// Triangles of 3 mm pass 3^2 / (8 * 20) = 0.06 mm within the condyles, which
// are 45 mm apart: a fourteenth of a degree. Their rounded edges and what joins
// them in front pull as much again.
constexpr double kKneeAngle = RadiansOf(0.2);
constexpr double kKneeOffset = 0.2;  // mm, across the axis

// Along the axis the middle is that of the points, of which a level cut leaves
// more on one condyle.
constexpr double kKneeMiddle = 1;  // mm

KneeFit KneeOf(const MadeFemur& femur, const SurfacePoints& points) {
  const auto fit =
      FitKnee(points, DirectionsOf(femur, points), kMadeHeadRadius);
  EXPECT_TRUE(fit);
  return fit.value_or(KneeFit());
}

void ExpectKnee(const MadeFemur& femur, const KneeFit& fit) {
  const Axis& axis = fit.cylinder.axis;
  EXPECT_LT(AngleBetween(axis.direction, femur.knee.direction), kKneeAngle);
  EXPECT_GT(axis.direction.dot(femur.left), 0.9);
  EXPECT_LT(OffsetFrom(femur.knee, axis.point).norm(), kKneeOffset);
  EXPECT_LT((axis.point - femur.knee.point).norm(), kKneeMiddle);
  EXPECT_NEAR(fit.cylinder.radius, kMadeCondyleRadius, kKneeOffset);
}

TEST(FitKnee, FindsTheAxisOfTheCondylesLeftAndRight) {
  const MadeFemur right = RightFemur(3);
  for (const MadeFemur& femur : {right, Mirrored(right)}) {
    const KneeFit fit = KneeOf(femur, SampleSurface(femur.surface));
    ExpectKnee(femur, fit);
    // Normals from 12 to 120 degrees are looked at; rounding of the front takes
    // some.
    for (const double angle : {fit.left_angle, fit.right_angle}) {
      EXPECT_GT(angle, RadiansOf(85));
      EXPECT_LE(angle, RadiansOf(120 - 12 + 2 * 5));
    }
    EXPECT_LT(fit.spread, 0.5);
    // Each condyle has 20 * (108 degrees) * (30 - 8) mm^2 without its edges.
    EXPECT_GT(fit.points, 0.8 * 20 * 1.88 * 22 / (1.2 * 1.2));
  }
}

TEST(FitKnee, FindsTheSameAxisInAnyOrientation) {
  const MadeFemur femur = RightFemur(3);
  const SurfacePoints points = SampleSurface(femur.surface);
  for (const int seed : {1, 2, 3}) {
    const Eigen::Isometry3d motion = RandomMotion(seed);
    const MadeFemur moved = MovedBy(motion, femur);
    ExpectKnee(moved, KneeOf(moved, MovedBy(motion, points)));
  }
}

TEST(FitKnee, FindsTheSameAxisFromDirectionsThatAreOff) {
  const MadeFemur femur = RightFemur(3);
  const SurfacePoints points = SampleSurface(femur.surface);
  const BoneDirections own = DirectionsOf(femur, points);
  // As those of an image may be, by 8 degrees about each.
  for (const Eigen::Vector3d& about : {own.up, own.back, own.left}) {
    for (const double sign : {-1.0, 1.0}) {
      const Eigen::AngleAxisd turn(RadiansOf(sign * 8), about);
      BoneDirections directions = own;
      directions.up = turn * own.up;
      directions.back = turn * own.back;
      directions.left = turn * own.left;
      directions.lowest = (points.points * directions.up).minCoeff();
      const auto fit = FitKnee(points, directions, kMadeHeadRadius);
      ASSERT_TRUE(fit);
      ExpectKnee(femur, *fit);
    }
  }
}

TEST(FitKnee, HasTheHeadOfARightFemurOnItsLeft) {
  const MadeFemur right = RightFemur(3);
  for (const bool is_right : {true, false}) {
    const MadeFemur femur = is_right ? right : Mirrored(right);
    const KneeFit fit = KneeOf(femur, SampleSurface(femur.surface));
    const double left =
        (femur.head - fit.cylinder.axis.point).dot(fit.cylinder.axis.direction);
    // 48 mm to the side, and 395 mm up along an axis that leans by 3 degrees.
    EXPECT_NEAR(std::abs(left), 48 + 395 * std::sin(RadiansOf(3)), 8);
    EXPECT_EQ(left > 0, is_right);
  }
}

TEST(FitKnee, FindsNothingWithoutASecondCondyle) {
  const MadeFemur femur = RightFemur(3);
  const SurfacePoints whole = SampleSurface(femur.surface);
  const BoneDirections directions = DirectionsOf(femur, whole);
  const SurfacePoints one = Filtered(whole, [&](int row) {
    // What is left of the other side looks forward.
    return whole.points(row, 0) > 0 || whole.normals(row, 1) < -0.2;
  });
  EXPECT_FALSE(FitKnee(one, directions, kMadeHeadRadius));
}

TEST(FitKnee, FindsNothingWithoutPoints) {
  EXPECT_FALSE(FitKnee(SampleSurface({}), BoneDirections(), 23));
}

}  // namespace
}  // namespace musclewarp
