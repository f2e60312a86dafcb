// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/cylinder_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "joints/ideal_surfaces.h"
#include "musclewarp/base/angles.h"

namespace musclewarp {
namespace {

constexpr double kCylinderRadius = 20;

// Two points in every sector of five degrees, but for a few at random.
constexpr int kManyPoints = 2000;

TEST(OffsetFrom, IsTheWayFromTheFootOnTheAxis) {
  const Axis axis = {{1, 2, 3}, {0, 0.6, 0.8}};
  const Eigen::Vector3d offset = OffsetFrom(axis, {4, 2, 3});
  EXPECT_LT((offset - Eigen::Vector3d(3, 0, 0)).norm(), 1e-15);
  EXPECT_LT(OffsetFrom(axis, axis.point + 7 * axis.direction).norm(), 1e-12);
}

TEST(FitCylinder, IsExactOnPointsOfACylinderInAnyOrientation) {
  // A fit ends with the step that changes the cost by less than 1e-6 mm^2: on
  // 500 points by some 1e-3 / sqrt(500) mm. Damping by 1e-4 leaves 5e-9 mm.
  constexpr double kExact = 5e-9;
  const SurfacePoints half = IdealCylinder(kCylinderRadius, 40, M_PI, 500);
  const Eigen::VectorXd weights = Eigen::VectorXd::Ones(half.size());
  for (int seed = 1; seed <= 20; ++seed) {
    const Eigen::Isometry3d motion = RandomMotion(seed);
    const Axis axis = MovedBy(motion, Axis());
    // 10 degrees, 2 mm and 3 mm off.
    Cylinder start = {{{1.5, -1.3, 0}, {0, 0.17, 0.98}}, 17};
    start.axis.direction.normalize();
    start.axis = MovedBy(motion, start.axis);
    const Cylinder fit =
        FitCylinder(MovedBy(motion, half).points, weights, start, 0.4);
    EXPECT_LT(AngleBetween(fit.axis.direction, axis.direction), kExact);
    EXPECT_LT(OffsetFrom(axis, fit.axis.point).norm(), kExact);
    EXPECT_NEAR(fit.radius, kCylinderRadius, kExact);
    EXPECT_NEAR(fit.axis.direction.norm(), 1, 1e-12);
    // Of the axis, the point nearest to the start.
    EXPECT_NEAR(
        (fit.axis.point - start.axis.point).dot(fit.axis.direction), 0, kExact);
  }
}

TEST(FitCylinder, FollowsThePointsWithTheLargerWeights) {
  // Cylinders of 20 and 21 mm with one axis.
  const SurfacePoints inner = IdealCylinder(20, 40, 2 * M_PI, 300);
  const SurfacePoints outer = IdealCylinder(21, 40, 2 * M_PI, 300);
  Points both(600, 3);
  both << inner.points, outer.points;
  const Cylinder start = {{}, 20};
  constexpr double kQuadratic = 1e3;  // mm, a scale that nothing lies beyond
  for (const double weight : {0.0, 0.5, 1.0, 2.0}) {
    Eigen::VectorXd weights = Eigen::VectorXd::Ones(600);
    weights.tail(300).setConstant(weight);
    // The mean of the radii by the squares of the weights. Points at random are
    // not quite even about the axis, which shifts it and the radius: by the
    // difference of the radii over the number of points.
    const double part = weight * weight / (1 + weight * weight);
    EXPECT_NEAR(
        FitCylinder(both, weights, start, kQuadratic).radius, 20 + part, 0.02);
  }
}

TEST(FitCylinder, HardlyFollowsPointsThatLieOff) {
  SurfacePoints surface = IdealCylinder(kCylinderRadius, 40, 2 * M_PI, 1000);
  // A fifth lies 5 mm off, all on one half, where they do not cancel out.
  int off = 0;
  for (int i = 0; i < surface.size(); ++i) {
    if (surface.normals(i, 1) < 0 || i % 5 < 3) continue;
    surface.points.row(i) += 5 * surface.normals.row(i);
    ++off;
  }
  ASSERT_GT(off, 150);
  const Cylinder start = {{}, kCylinderRadius};
  const Eigen::VectorXd weights = Eigen::VectorXd::Ones(surface.size());
  const auto error = [&](double scale) {
    return OffsetFrom(
               {},
               FitCylinder(surface.points, weights, start, scale).axis.point)
        .norm();
  };
  // Least squares move the axis by the mean of 5 mm times the component of the
  // normal, by the mean of the squares of the components:
  // (0.18 * 5 * 2 / pi) / (1 / 2) = 1.1 mm.
  EXPECT_GT(error(1e4), 0.8);
  // Robustly each pulls with at most the scale instead of 5 mm. They hold
  // nothing themselves, and the others yield a little: 0.09 mm become 0.16 mm.
  EXPECT_LT(error(0.4), 0.2);
}

TEST(PointsOnCylinder, AreNearAndFaceAwayFromTheAxis) {
  const SurfacePoints outward = IdealCylinder(20, 40, 2 * M_PI, 200);
  SurfacePoints inward = outward;
  inward.normals *= -1;
  const auto on = [](const SurfacePoints& points, double radius) {
    return PointsOn(points, {{}, radius}, 1).size();
  };
  EXPECT_EQ(on(outward, 20), 200);
  EXPECT_EQ(on(outward, 20.99), 200);
  EXPECT_EQ(on(outward, 21.01), 0);
  EXPECT_EQ(on(outward, 18.99), 0);
  EXPECT_EQ(on(inward, 20), 0);
  // 31 and 33 degrees off the radius.
  for (const double slant : {31.0, 33.0}) {
    SurfacePoints tilted = outward;
    tilted.normals *= std::cos(RadiansOf(slant));
    tilted.normals.col(2).setConstant(std::sin(RadiansOf(slant)));
    EXPECT_EQ(on(tilted, 20), slant < 32 ? 200 : 0);
  }
}

TEST(AngleCovered, IsThatOfTheSectorsWithPoints) {
  // A sector at each end may be covered in part.
  constexpr double kSector = RadiansOf(5);
  for (const double angle : {M_PI / 3, M_PI, 1.5 * M_PI}) {
    const SurfacePoints part = IdealCylinder(20, 40, angle, kManyPoints);
    for (const int seed : {1, 2, 3}) {
      const Eigen::Isometry3d motion = RandomMotion(seed);
      EXPECT_NEAR(
          AngleCovered(MovedBy(motion, part).points, MovedBy(motion, Axis())),
          angle,
          2 * kSector + 1e-9);
    }
  }
  EXPECT_NEAR(
      AngleCovered(IdealCylinder(20, 40, 2 * M_PI, kManyPoints).points, Axis()),
      2 * M_PI,
      1e-9);
}

TEST(AngleCovered, NeedsTwoPointsInASector) {
  EXPECT_EQ(AngleCovered(Points(0, 3), Axis()), 0);
  Points points(3, 3);
  points << 10, 0.1, 0, 10, 0.2, 5, -10, 3, 0;
  EXPECT_NEAR(AngleCovered(points, Axis()), RadiansOf(5), 1e-12);
  EXPECT_EQ(AngleCovered(points.bottomRows(2), Axis()), 0);
}

TEST(SpreadAboutCylinder, IsTheRootMeanSquareOfDistances) {
  const Cylinder cylinder = {{}, 20};
  EXPECT_EQ(SpreadAbout(cylinder, Points(0, 3)), 0);
  const SurfacePoints on = IdealCylinder(20, 40, M_PI, 100);
  EXPECT_NEAR(SpreadAbout(cylinder, on.points), 0, 1e-12);
  Points points(2, 3);
  points << 23, 0, 7, 0, -16, -90;  // 3 mm outside, 4 mm inside
  EXPECT_NEAR(SpreadAbout(cylinder, points), std::sqrt(12.5), 1e-12);
}

}  // namespace
}  // namespace musclewarp
