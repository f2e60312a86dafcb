// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/revolution_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "joints/ideal_surfaces.h"
#include "musclewarp/base/angles.h"
#include "musclewarp/joints/surface_points.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

// Expects the axis of a surface of revolution about z, however it is moved.
void ExpectExactAxis(const SurfacePoints& surface) {
  // The axis is an eigenvector of a matrix whose smallest eigenvalue is zero
  // but for rounding.
  constexpr double kExact = 1e-9;
  for (int seed = 1; seed <= 10; ++seed) {
    const Eigen::Isometry3d motion = RandomMotion(seed);
    const SurfacePoints moved = MovedBy(motion, surface);
    const Axis axis = MovedBy(motion, Axis());
    const auto fit = FitRevolution(moved);
    ASSERT_TRUE(fit);
    EXPECT_LT(AngleBetween(fit->axis.direction, axis.direction), kExact);
    EXPECT_NEAR(fit->axis.direction.norm(), 1, 1e-12);
    EXPECT_LT(OffsetFrom(axis, fit->axis.point).norm(), kExact);
    EXPECT_LT(fit->spread, kExact);
    // All normals of a second axis would be a millimetre off and more.
    EXPECT_GT(fit->next_spread, 1);
    // The point is the one of the axis that is nearest to the mean.
    const Eigen::Vector3d mean = moved.points.colwise().mean().transpose();
    EXPECT_NEAR((fit->axis.point - mean).dot(axis.direction), 0, 1e-9);
  }
}

TEST(FitRevolution, IsExactOnAnEllipsoid) {
  ExpectExactAxis(IdealEllipsoid(20, 35, 400));
  ExpectExactAxis(IdealEllipsoid(30, 20, 400));
}

TEST(FitRevolution, IsExactOnAPartOfATorus) {
  ExpectExactAxis(IdealTorus(20, 8, 2 * M_PI, 400));
  ExpectExactAxis(IdealTorus(20, 8, RadiansOf(100), 400));
}

TEST(FitRevolution, IsExactOnACylinder) {
  // The normals leave open where along the axis its point is.
  ExpectExactAxis(IdealCylinder(20, 30, M_PI, 400));
}

TEST(FitRevolution, HardlyFollowsNormalsThatPassTheAxis) {
  SurfacePoints surface = IdealTorus(20, 8, M_PI, 1000);
  const double exact = FitRevolution(surface)->spread;
  // A fifth belongs to another torus beside it.
  for (int i = 0; i < 200; ++i) surface.points.row(i).x() += 15;
  const auto fit = FitRevolution(surface);
  ASSERT_TRUE(fit);
  EXPECT_GT(fit->spread, exact + 1);
  // Least squares would move the axis by a fifth of 15 mm. With weights of
  // 1 / sqrt(1 + d^2) a normal that passes at 5 to 15 mm counts a tenth.
  EXPECT_LT(OffsetFrom({}, fit->axis.point).norm(), 15 / 5.0 / 5);
  EXPECT_LT(AngleBetween(fit->axis.direction, {0, 0, 1}), RadiansOf(2));
}

TEST(FitRevolution, KnowsThatASphereHasNoAxis) {
  const auto sphere = FitRevolution(SampleSurface(Icosphere(20, 3)));
  ASSERT_TRUE(sphere);
  // Both spreads are those of the normals of triangles, which are up to 0.09
  // off, of 20 mm.
  EXPECT_LT(sphere->next_spread, 1.2 * sphere->spread);
  EXPECT_LT(sphere->next_spread, 0.09 * 20);
  // The same mesh stretched is one of revolution about one axis only.
  const auto spindle = FitRevolution(SampleSurface(Spindle(20, 35, 3)));
  ASSERT_TRUE(spindle);
  EXPECT_GT(spindle->next_spread, 5 * spindle->spread);
  // The triangles of an icosphere favour no direction.
  EXPECT_LT(AngleBetween(spindle->axis.direction, {0, 0, 1}), RadiansOf(1));
}

TEST(FitRevolution, NeedsSixPoints) {
  const SurfacePoints six = IdealEllipsoid(20, 35, 6);
  EXPECT_TRUE(FitRevolution(six));
  EXPECT_FALSE(FitRevolution(Subset(six, {0, 1, 2, 3, 4})));
  EXPECT_FALSE(FitRevolution({}));
}

}  // namespace
}  // namespace musclewarp
