// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/phantom/field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace musclewarp::phantom {
namespace {

Eigen::Vector3d RandomPoint(std::mt19937* random, double reach) {
  Eigen::Vector3d p;
  for (int axis = 0; axis < 3; ++axis) {
    p[axis] = reach * ((*random)() / 2147483647.5 - 1);
  }
  return p;
}

TEST(SmoothMin, LiesBelowTheSharpOneByAQuarterOfTheWidthAtMost) {
  for (double a = -3; a <= 3; a += 0.25) {
    for (double b = -3; b <= 3; b += 0.25) {
      const double sharp = std::min(a, b);
      const double smooth = SmoothMin(a, b, 2);
      // Quarters and products of them: exact in floating point.
      EXPECT_LE(smooth, sharp);
      EXPECT_GE(smooth, sharp - 0.5);
      EXPECT_EQ(smooth, SmoothMin(b, a, 2));
      EXPECT_EQ(SmoothMax(-a, -b, 2), -smooth);
      if (std::abs(a - b) >= 2) {
        EXPECT_EQ(smooth, sharp);
      }
    }
  }
  EXPECT_EQ(SmoothMin(1, 1, 2), 0.5);
  EXPECT_EQ(SmoothMin(1, 2, 0), 1);
}

TEST(SmoothStep, RisesFromZeroToOne) {
  EXPECT_EQ(SmoothStep(2, 4, 1), 0);
  EXPECT_EQ(SmoothStep(2, 4, 3), 0.5);
  EXPECT_EQ(SmoothStep(2, 4, 5), 1);
}

TEST(Sweep, OfTwoNodesIsACapsule) {
  const Field capsule = Sweep({{{0, 0, 0}, 3}, {{0, 0, 10}, 3}});
  // The curve through two nodes is straight; rounding of ten millimetres.
  constexpr double kTolerance = 1e-12;
  EXPECT_NEAR(capsule({0, 0, 5}), -3, kTolerance);
  EXPECT_NEAR(capsule({7, 0, 4}), 4, kTolerance);
  EXPECT_NEAR(capsule({0, 4, 13}), 2, kTolerance);
}

TEST(Sweep, IsContinuousAcrossItsParts) {
  const Field sweep = Sweep({{{0, 0, 0}, 5}, {{20, 3, 0}, 7}, {{35, 0, 9}, 4}});
  constexpr double kStep = 0.01;  // mm
  for (double x = -8; x < 42; x += kStep) {
    const Eigen::Vector3d p(x, 1, 2);
    // One per millimetre, and what the radius adds: under two.
    EXPECT_NEAR(
        sweep(p), sweep(p + kStep * Eigen::Vector3d::UnitX()), 2 * kStep);
  }
}

TEST(Sweep, FarAwayIsNeverMoreThanTheDistance) {
  const Field ball = Sweep({{{-1, 0, 0}, 2}, {{1, 0, 0}, 2}});
  const Field exact = Sphere({0, 0, 0}, 3);  // contains the capsule, touches it
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d p = RandomPoint(&random, 60);
    if (exact(p) < 0) continue;
    EXPECT_GT(ball(p), 0);
    EXPECT_LE(ball(p), exact(p) + 1 + 1e-12);
  }
}

TEST(Ellipsoid, OfEqualAxesIsASphere) {
  const Eigen::Vector3d centre(1, 2, 3);
  const Field ellipsoid = Ellipsoid(centre, {5, 5, 5});
  const Field sphere = Sphere(centre, 5);
  std::mt19937 random(2);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d p = RandomPoint(&random, 20);
    EXPECT_NEAR(ellipsoid(p), sphere(p), 1e-12);  // rounding
  }
}

TEST(Operators, KeepTheSigns) {
  const Field a = Sphere({0, 0, 0}, 5);
  const Field b = HalfSpace({0, 0, 2}, 2);  // z < 1
  std::mt19937 random(3);
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector3d p = RandomPoint(&random, 8);
    EXPECT_EQ(Union(a, b, 0)(p) < 0, a(p) < 0 || b(p) < 0);
    EXPECT_EQ(Intersection(a, b, 0)(p) < 0, a(p) < 0 && b(p) < 0);
    EXPECT_EQ(Difference(a, b, 0)(p) < 0, a(p) < 0 && b(p) > 0);
    EXPECT_EQ(Offset(a, 2)(p), a(p) - 2);
  }
}

TEST(Rough, MovesTheSurfaceByTheAmplitudeAtMost) {
  const Field sphere = Sphere({0, 0, 0}, 5);
  const Field rough = Rough(sphere, 0.3, 2, 7);
  const Field other = Rough(sphere, 0.3, 2, 8);
  std::mt19937 random(4);
  bool differs = false;
  double largest = 0;
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector3d p = 5 * RandomPoint(&random, 1).normalized();
    EXPECT_LE(std::abs(rough(p) - sphere(p)), 0.3);
    largest = std::max(largest, std::abs(rough(p) - sphere(p)));
    differs = differs || rough(p) != other(p);
  }
  EXPECT_GT(largest, 0.1);
  EXPECT_TRUE(differs);
}

}  // namespace
}  // namespace musclewarp::phantom
