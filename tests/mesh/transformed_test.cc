// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh/transformed.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "musclewarp/mesh/measures.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

// Products and sums of a few numbers of size 10.
constexpr double kRounding = 1e-13;

Eigen::Matrix4d SomeMotion() {
  const Eigen::Isometry3d motion =
      Eigen::Translation3d(3, -7, 2) *
      Eigen::AngleAxisd(0.8, Eigen::Vector3d(1, 2, -2) / 3);
  return motion.matrix();
}

TEST(Transformed, TurnsThenShifts) {
  // A quarter turn about z, then a shift.
  Eigen::Matrix4d b_from_a;
  b_from_a << 0, -1, 0, 10, 1, 0, 0, 20, 0, 0, 1, 30, 0, 0, 0, 1;
  Points points(2, 3);
  points << 1, 2, 3, 0, 0, 0;
  Points expected(2, 3);
  expected << 8, 21, 33, 10, 20, 30;
  EXPECT_EQ(Transformed(points, b_from_a), expected);
}

TEST(Transformed, ByTheIdentityChangesNoBit) {
  const Points points = RandomPoints(20, 1);
  EXPECT_EQ(Transformed(points, Eigen::Matrix4d::Identity()), points);
}

TEST(Transformed, ByAProductIsTransformedTwice) {
  const Points points = RandomPoints(20, 1);
  const Eigen::Matrix4d b_from_a = SomeMotion();
  const Eigen::Matrix4d c_from_b = b_from_a * b_from_a;
  EXPECT_LT((Transformed(points, c_from_b * b_from_a) -
             Transformed(Transformed(points, b_from_a), c_from_b))
                .cwiseAbs()
                .maxCoeff(),
            10 * kRounding);
}

TEST(Transformed, ByAnAffineMapScalesTheVolumeByTheDeterminant) {
  const TriangleSoup ball = Icosphere(1, 2);
  Eigen::Matrix4d b_from_a = SomeMotion();
  b_from_a.leftCols<1>() *= 2;
  b_from_a.col(2) *= -3;
  EXPECT_NEAR(SignedVolume(Transformed(ball.points, b_from_a), ball.triangles),
              -6 * SignedVolume(ball.points, ball.triangles),
              // A sum of 320 terms of size 100.
              1e-10);
}

TEST(Transformed, ABoxStaysAroundItsPoints) {
  const Points points = RandomPoints(200, 1);
  const Eigen::Matrix4d b_from_a = SomeMotion();
  const Box3 box = Transformed(BoxOf(points), b_from_a);
  const Points moved = Transformed(points, b_from_a);
  for (const auto p : moved.rowwise()) {
    // Corners and points are rounded apart.
    EXPECT_LT(box.SquaredDistance(Eigen::RowVector3d(p)),
              kRounding * kRounding);
  }
  const Box3 same = Transformed(BoxOf(points), Eigen::Matrix4d::Identity());
  EXPECT_EQ(same.lower, BoxOf(points).lower);
  EXPECT_EQ(same.upper, BoxOf(points).upper);
}

TEST(RigidInverse, UndoesTheMotion) {
  const Eigen::Matrix4d b_from_a = SomeMotion();
  const Points points = RandomPoints(20, 1);
  EXPECT_LT((RigidInverse(b_from_a) * b_from_a - Eigen::Matrix4d::Identity())
                .cwiseAbs()
                .maxCoeff(),
            kRounding);
  EXPECT_LT(
      (Transformed(Transformed(points, b_from_a), RigidInverse(b_from_a)) -
       points)
          .cwiseAbs()
          .maxCoeff(),
      kRounding);
}

}  // namespace
}  // namespace musclewarp
