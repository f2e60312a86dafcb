// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/proximity/distance_field.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/meshes.h"

namespace musclewarp {
namespace {

constexpr double kCell = 3;    // mm
constexpr double kReach = 12;  // mm

DistanceField BallField() { return {Icosphere(20, 4), kCell, kReach}; }

// Means of samples two spacings apart are off by the curvature of the distance
// times half a spacing squared, and by the flat triangles of the ball.
constexpr double kTolerance = kCell * kCell / 20;

TEST(DistanceField, IsTheDistanceToABall) {
  const DistanceField field = BallField();
  DistanceField::Value value;
  for (const double radius : {12.0, 17.3, 20.0, 23.9}) {
    const Eigen::RowVector3d place =
        radius * Eigen::RowVector3d(1, -2, 0.5).normalized();
    ASSERT_TRUE(field.IsBelow(5, place, &value));
    EXPECT_NEAR(value.distance, radius - 20, kTolerance);
    EXPECT_LT((value.gradient - place.normalized()).norm(), 0.1);
  }
}

TEST(DistanceField, KnowsWhatIsBeyondTheLimit) {
  const DistanceField field = BallField();
  DistanceField::Value value;
  EXPECT_FALSE(field.IsBelow(1, {0, 0, 24}, &value));
  EXPECT_FALSE(field.IsBelow(5, {0, 300, 0}, &value));
  EXPECT_TRUE(field.IsBelow(5, {0, 0, 24}, &value));
}

// Law: nowhere within r of a place is the distance less than its bound less r.
TEST(DistanceField, IsNotBelowItsBound) {
  const DistanceField field = BallField();
  DistanceField::Value value;
  const Eigen::RowVector3d way = Eigen::RowVector3d(-2, 1, 1).normalized();
  for (double radius = 1; radius < 30; radius += 0.7) {
    const Eigen::RowVector3d place = radius * way;
    const double bound = field.LowerBound(place);
    EXPECT_GT(bound, std::min(radius - 20, kReach) - 3 * kCell);
    for (const double r : {0.0, 1.0, 4.0, 8.0}) {
      EXPECT_FALSE(field.IsBelow(bound - r - 1e-6, place - r * way, &value) &&
                   radius > r)
          << radius << " " << r;
    }
  }
  EXPECT_EQ(field.LowerBound({0, 300, 0}), 0);
}

TEST(DistanceField, DerivativesAreThoseOfTheDistance) {
  const DistanceField field = BallField();
  // Off the planes where the second derivatives jump.
  const Eigen::RowVector3d place(7.1, 11.9, -12.2);
  constexpr double kStep = 1e-4;
  DistanceField::Value here, before, after;
  ASSERT_TRUE(field.IsBelow(5, place, &here));
  for (int c = 0; c < 3; ++c) {
    Eigen::RowVector3d step = Eigen::RowVector3d::Zero();
    step[c] = kStep;
    ASSERT_TRUE(field.IsBelow(5, place - step, &before));
    ASSERT_TRUE(field.IsBelow(5, place + step, &after));
    EXPECT_NEAR(here.gradient[c],
                (after.distance - before.distance) / (2 * kStep),
                1e-9);  // of a parabola, exact to rounding
    const Eigen::RowVector3d bend =
        (after.gradient - before.gradient) / (2 * kStep);
    EXPECT_LT((here.curvature.row(c) - bend).norm(), 1e-7);
  }
}

TEST(DistanceField, TheGradientIsContinuousBetweenCells) {
  const DistanceField field = BallField();
  DistanceField::Value below, above;
  // Cells begin halfway between samples.
  ASSERT_TRUE(field.IsBelow(5, {16.5 - 1e-9, 4, 3}, &below));
  ASSERT_TRUE(field.IsBelow(5, {16.5 + 1e-9, 4, 3}, &above));
  EXPECT_NEAR(below.distance, above.distance, 1e-8);
  EXPECT_LT((below.gradient - above.gradient).norm(), 1e-8);
}

// As with units mixed up: no more memory than for any other.
TEST(DistanceField, HasCoarserSamplesOfAHugeSurface) {
  const double radius = 1e7;
  const DistanceField field(Icosphere(radius, 4), kCell, kReach);
  DistanceField::Value value;
  ASSERT_TRUE(field.IsBelow(0, {0, 0, 0.9 * radius}, &value));
  EXPECT_NEAR(value.distance, -0.1 * radius, 0.01 * radius);
  EXPECT_FALSE(field.IsBelow(0, {0, 0, 1.1 * radius}, &value));
}

TEST(DistanceField, AMirroredSurfaceHasTheMirroredField) {
  const TriangleSoup ball = SphereAt({7.7, 3, -2}, 12, 3);
  TriangleSoup mirrored = ball;
  mirrored.points.col(0) *= -1;
  mirrored.triangles.col(0).swap(mirrored.triangles.col(1));
  const DistanceField field(ball, kCell, kReach);
  const DistanceField other(mirrored, kCell, kReach);
  DistanceField::Value here, there;
  for (const Eigen::RowVector3d& place :
       {Eigen::RowVector3d(10, 9, 3), Eigen::RowVector3d(-3.3, 4, 2)}) {
    ASSERT_TRUE(field.IsBelow(5, place, &here));
    ASSERT_TRUE(other.IsBelow(
        5, place.cwiseProduct(Eigen::RowVector3d(-1, 1, 1)), &there));
    EXPECT_NEAR(here.distance, there.distance, 1e-6);  // samples are floats
  }
}

}  // namespace
}  // namespace musclewarp
