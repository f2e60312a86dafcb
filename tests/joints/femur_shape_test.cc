// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/femur_shape.h"

#include <gtest/gtest.h>

#include <cmath>

#include "joints/ideal_surfaces.h"
#include "musclewarp/base/angles.h"
#include "support/made_bones.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

// The shaft is straight, and every slice of it round: what is left is the
// noise of points: 300 of them in each slice, whose mean is off by a tenth of
// a millimetre, and 20 slices over 180 mm.
constexpr double kShaftTolerance = RadiansOf(0.1);

// Left and back follow the widest direction of the lower end. It is cut level
// although it leans by 3 degrees, which makes it
// lopsided.
constexpr double kSideTolerance = RadiansOf(0.5);

double AngleOf(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

TEST(ShaftOf, IsTheLineThroughTheMiddleOfABar) {
  const SurfacePoints bar = MovedBy(
      RandomMotion(3), SampleSurface(MovedBy(Box(20, 24, 300), {4, -7, 50})));
  const Axis middle = {{4, -7, 50}, Eigen::Vector3d::UnitZ()};
  const Axis expected = MovedBy(RandomMotion(3), middle);
  for (const double sign : {1.0, -1.0}) {
    // Up is told by any direction within a right angle.
    const Eigen::Vector3d up =
        sign * (expected.direction + 0.5 * expected.direction.unitOrthogonal());
    const Axis shaft = ShaftOf(bar, up);
    EXPECT_LT(AngleOf(shaft.direction, sign * expected.direction),
              kShaftTolerance);
    // Slices of 6 mm have some 370 points, 20 slices 7000, spread by 10 mm.
    EXPECT_LT(OffsetFrom(expected, shaft.point).norm(), 0.3);
  }
}

TEST(DirectionsOfFemur, AreThoseOfItsShaftAndItsCondyles) {
  const MadeFemur right = RightFemur(3);
  for (const MadeFemur& femur : {right, Mirrored(right)}) {
    const BoneDirections directions =
        DirectionsOf(femur, SampleSurface(femur.surface));
    EXPECT_LT(AngleOf(directions.up, femur.up), kShaftTolerance);
    EXPECT_LT(AngleOf(directions.back, femur.back), kSideTolerance);
    EXPECT_LT(AngleOf(directions.left, femur.left), kSideTolerance);
    EXPECT_EQ(directions.shaft.direction, directions.up);
    // The lowest place is on the lower condyle: its middle, 3 degrees lower
    // over 22.5 mm, and a radius below.
    EXPECT_NEAR(directions.lowest, -20 - 37.5 * std::sin(RadiansOf(3)), 1);
    // Condyles reach 34 mm back from the shaft, the front 17 mm forward.
    EXPECT_GT(directions.back_to_front, 1.9);
    EXPECT_LT(directions.back_to_front, 2.1);
  }
}

TEST(DirectionsOfFemur, MoveWithTheBone) {
  const MadeFemur femur = RightFemur(3);
  const SurfacePoints points = SampleSurface(femur.surface);
  for (int seed = 1; seed <= 10; ++seed) {
    const Eigen::Isometry3d motion = RandomMotion(seed);
    const MadeFemur moved = MovedBy(motion, femur);
    const BoneDirections directions =
        DirectionsOf(moved, MovedBy(motion, points));
    EXPECT_LT(AngleOf(directions.up, moved.up), kShaftTolerance);
    EXPECT_LT(AngleOf(directions.back, moved.back), kSideTolerance);
    EXPECT_LT(AngleOf(directions.left, moved.left), kSideTolerance);
    EXPECT_LT((directions.back.cross(directions.up) - directions.left).norm(),
              1e-12);
    EXPECT_NEAR(directions.left.norm(), 1, 1e-12);
  }
}

TEST(DirectionsOfFemur, TellTheSideByTheHead) {
  // The head is on the medial side: to the left of a right knee.
  const MadeFemur right = RightFemur(3);
  for (const bool is_right : {true, false}) {
    const MadeFemur femur = MovedBy(RandomMotion(is_right ? 4 : 5),
                                    is_right ? right : Mirrored(right));
    const BoneDirections directions =
        DirectionsOf(femur, SampleSurface(femur.surface));
    const double medial =
        OffsetFrom(directions.shaft, femur.head).dot(directions.left);
    // The made head is 48 mm beside the shaft.
    EXPECT_NEAR(medial, is_right ? 48 : -48, 2);
  }
}

}  // namespace
}  // namespace musclewarp
