// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/paper_contact/bounding_capsule.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "proximity/random_meshes.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

double DistanceTo(const Capsule& capsule, const RowVector3d& p) {
  return SegmentDistance(p, p, capsule.start, capsule.end);
}

Points RandomCubePoints(int count, std::mt19937* random) {
  Points points(count, 3);
  for (int i = 0; i < count; ++i) points.row(i) = RandomPoint(10, random);
  return points;
}

}  // namespace

TEST(BoundingCapsule, ContainsAllPoints) {
  std::mt19937 random(1);
  for (int count : {1, 2, 3, 5, 50}) {
    for (int trial = 0; trial < 50; ++trial) {
      const Points points = RandomCubePoints(count, &random);
      const Capsule capsule = BoundingCapsule(points);
      for (const RowVector3d p : points.rowwise()) {
        EXPECT_LE(DistanceTo(capsule, p), capsule.radius);
      }
    }
  }
}

TEST(BoundingCapsule, LiesAlongAMuscle) {
  // The cosine of the angle to the axis, which is known to about the root of
  // rounding.
  constexpr double kCosine = 1e-6;
  const Capsule capsule = BoundingCapsule(Spindle(12, 60, 3).points);
  // A capsule of the spindle's thickness, at most as long as the spindle.
  EXPECT_NEAR(capsule.radius, 12, 0.5);
  EXPECT_LE((capsule.end - capsule.start).norm(), 120);
  EXPECT_NEAR(
      std::abs((capsule.end - capsule.start).normalized().z()), 1, kCosine);
}

TEST(BoundingCapsule, OfCoincidentPointsIsAPoint) {
  const Capsule capsule = BoundingCapsule(Points::Constant(7, 3, 2.5));
  // The radius has a margin for rounding.
  constexpr double kMargin = 1e-9;
  EXPECT_NEAR(capsule.radius, 0, kMargin);
  EXPECT_TRUE(Overlap(capsule, capsule));
}

TEST(BoundingCapsule, OfNothingOverlapsNothing) {
  const Capsule none = BoundingCapsule(Points(0, 3));
  EXPECT_FALSE(Overlap(none, BoundingCapsule(Points::Zero(1, 3))));
  EXPECT_FALSE(Overlap(none, none));
}

TEST(BoundingCapsule, MeshesThatShareAPointHaveCapsulesThatOverlap) {
  std::mt19937 random(2);
  int apart = 0;
  for (int trial = 0; trial < 500; ++trial) {
    const Points a = RandomCubePoints(6, &random);
    Points b = RandomCubePoints(6, &random);
    EXPECT_TRUE(Overlap(BoundingCapsule(a), BoundingCapsule(b)) ||
                (a.rowwise() - b.row(0)).rowwise().norm().minCoeff() > 0);
    b.row(0) = a.row(3);
    EXPECT_TRUE(Overlap(BoundingCapsule(a), BoundingCapsule(b)));
    b.rowwise() += RowVector3d(30, 0, 0);
    apart += !Overlap(BoundingCapsule(a), BoundingCapsule(b));
  }
  EXPECT_GT(apart, 100);
}

TEST(BoundingCapsule, CapsulesThatTouchShareAPoint) {
  const Capsule a = {RowVector3d(0, 0, 0), RowVector3d(0, 0, 8), 2};
  const Capsule beside = {RowVector3d(5, 0, 4), RowVector3d(9, 0, 4), 3};
  const Capsule beyond = {RowVector3d(3, 0, 12), RowVector3d(3, 0, 20), 3};
  for (Capsule b : {beside, beyond}) {
    EXPECT_TRUE(Overlap(a, b));
    EXPECT_TRUE(Overlap(b, a));
    constexpr double kHair = 1e-9;  // more than the sum of radii is rounded
    b.radius -= kHair;
    EXPECT_FALSE(Overlap(a, b));
  }
}

TEST(BoundingCapsule, OverlapMovesWithThem) {
  std::mt19937 random(3);
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized())
          .toRotationMatrix();
  for (int trial = 0; trial < 500; ++trial) {
    Capsule a{RandomPoint(10, &random), RandomPoint(10, &random), 2};
    Capsule b{RandomPoint(10, &random), RandomPoint(10, &random), 3};
    const bool overlap = Overlap(a, b);
    EXPECT_EQ(Overlap(b, a), overlap);
    for (Capsule* c : {&a, &b}) {
      c->start = c->start * rotation + RowVector3d(5, -1, 2);
      c->end = c->end * rotation + RowVector3d(5, -1, 2);
    }
    EXPECT_EQ(Overlap(a, b), overlap);
  }
}

TEST(SegmentDistance, IsTheLeastOfAllPoints) {
  std::mt19937 random(4);
  for (int trial = 0; trial < 200; ++trial) {
    const RowVector3d a = RandomPoint(1, &random), b = RandomPoint(1, &random);
    const RowVector3d c = RandomPoint(1, &random);
    const RowVector3d d = trial % 4 == 0 ? c : RandomPoint(1, &random);
    const double distance = SegmentDistance(a, b, c, d);
    double least = INFINITY;
    for (int i = 0; i <= 100; ++i) {
      for (int j = 0; j <= 100; ++j) {
        least = std::min(
            least, (a + 0.01 * i * (b - a) - c - 0.01 * j * (d - c)).norm());
      }
    }
    // Rounding of coordinates of size 1.
    constexpr double kRounding = 1e-12;
    EXPECT_LE(distance, least + kRounding);
    // Segments are shorter than 3.5, so that samples are at most 0.035 apart.
    constexpr double kSpacing = 0.035;
    EXPECT_GE(distance, least - kSpacing);
  }
}

TEST(SegmentDistance, KnowsParallelCrossingAndPoints) {
  EXPECT_DOUBLE_EQ(SegmentDistance({0, 0, 0}, {2, 0, 0}, {1, 3, 0}, {5, 3, 0}),
                   3);
  EXPECT_DOUBLE_EQ(SegmentDistance({0, 0, 0}, {2, 0, 0}, {1, -1, 0}, {1, 1, 0}),
                   0);
  EXPECT_DOUBLE_EQ(SegmentDistance({0, 0, 0}, {0, 0, 0}, {3, 4, 0}, {3, 4, 0}),
                   5);
}

}  // namespace musclewarp
