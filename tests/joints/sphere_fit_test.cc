// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/sphere_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "joints/ideal_surfaces.h"
#include "support/made_bones.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

// A radius at which a fit counts less what is farther off, mm.
constexpr double kScale = 0.4;

// The centre of a head. Triangles of 3 mm pass 3^2 / (8 * 23) = 0.05 mm within
// the sphere; the hole where the neck begins lets the centre follow by as much,
// and the neck widens the sphere around it.
constexpr double kHeadTolerance = 0.2;

TEST(FitSphere, IsExactOnPointsOfASphere) {
  const Eigen::Vector3d center(100, -250, 40);
  const SurfacePoints whole = IdealSphere(center, 24, 400);
  const SurfacePoints cap =
      Filtered(whole, [&](int row) { return whole.normals(row, 2) > 0.5; });
  // A fit ends with the step that changes the cost by less than 1e-6 mm^2: on
  // the 100 points of the cap by some 1e-3 / sqrt(100) mm. What is left after
  // it is less than a thousandth of the step.
  constexpr double kExact = 1e-7;
  for (const SurfacePoints& points : {whole, cap}) {
    const Sphere start = {center + Eigen::Vector3d(2, -1.5, 1), 21};
    const Sphere sphere = FitSphere(points.points, start, kScale);
    EXPECT_LT((sphere.center - center).norm(), kExact);
    EXPECT_NEAR(sphere.radius, 24, kExact);
  }
}

TEST(FitSphere, HardlyFollowsPointsThatLieOff) {
  const Eigen::Vector3d center(10, 20, 30);
  SurfacePoints surface = IdealSphere(center, 24, 1000);
  // A fifth of the points, all on the upper half, where they do not cancel out.
  int off = 0;
  double up = 0;  // sum of their normals along z
  for (int i = 0; i < 500; i += 5) {
    for (const int row : {i, i + 2}) {
      surface.points.row(row) += 5 * surface.normals.row(row);
      up += surface.normals(row, 2);
      ++off;
    }
  }
  ASSERT_EQ(off, 200);
  // A centre that moves by m along z changes the distance of a point by m n_z,
  // whose squares have the mean 1/3: least squares move it by this.
  const double plain = 5 * up / 1000 / (1 / 3.0);
  ASSERT_GT(plain, 1.4);
  const Sphere start = {center, 24};
  const Sphere followed = FitSphere(surface.points, start, 1e4);
  EXPECT_NEAR((followed.center - center).norm(), plain, 0.3);
  // Robustly each pulls with at most the scale, 0.4 instead of 5 mm. They hold
  // nothing themselves, and the others yield a little: a twelfth of the 1.5 mm
  // becomes a sixth.
  const Sphere fitted = FitSphere(surface.points, start, kScale);
  EXPECT_LT((fitted.center - center).norm(), plain / 5);
  EXPECT_NEAR(fitted.radius, 24, plain / 5);
}

TEST(FindSphere, FindsTheHeadOfAFemurLeftAndRight) {
  const MadeFemur right = RightFemur(3);
  for (const MadeFemur& femur : {right, Mirrored(right)}) {
    const auto fit = FindSphere(SampleSurface(femur.surface), {});
    ASSERT_TRUE(fit);
    EXPECT_LT((fit->sphere.center - femur.head).norm(), kHeadTolerance);
    EXPECT_NEAR(fit->sphere.radius, kMadeHeadRadius, kHeadTolerance);
    // The neck, of 14 mm, covers 1 - sqrt(1 - (14 / 23)^2) = 0.2 of a half; the
    // edge where both meet is rounded.
    EXPECT_LT(fit->coverage, 0.9);
    EXPECT_GT(fit->coverage, 0.75);
    EXPECT_LT(fit->spread, kHeadTolerance);
  }
}

TEST(FindSphere, FindsTheSameHeadInAnyOrientation) {
  const SurfacePoints femur = SampleSurface(RightFemur(3).surface);
  const auto still = FindSphere(femur, {});
  ASSERT_TRUE(still);
  for (const int seed : {1, 2}) {
    const Eigen::Isometry3d motion = RandomMotion(seed);
    const auto moved = FindSphere(MovedBy(motion, femur), {});
    ASSERT_TRUE(moved);
    // Votes are counted in other cells, so that fits start elsewhere; in the
    // end they are to the same points, but for what FitSphere leaves.
    constexpr double kSame = 1e-6;
    EXPECT_LT((moved->sphere.center - motion * still->sphere.center).norm(),
              kSame);
    EXPECT_NEAR(moved->sphere.radius, still->sphere.radius, kSame);
    EXPECT_NEAR(moved->coverage, still->coverage, kSame);
  }
}

TEST(FindSphere, FindsTheSameHeadWhateverTheTriangles) {
  const MadeFemur fine = RightFemur(1.5);
  const auto fit = FindSphere(SampleSurface(fine.surface), {});
  ASSERT_TRUE(fit);
  EXPECT_LT((fit->sphere.center - fine.head).norm(), kHeadTolerance);
  const auto coarse = FindSphere(SampleSurface(RightFemur(3).surface), {});
  ASSERT_TRUE(coarse);
  // Both are within it of the truth, on the same side of the neck.
  EXPECT_LT((coarse->sphere.center - fit->sphere.center).norm(),
            kHeadTolerance / 2);
}

TEST(FindSphere, FindsASocketIfItLooksForAHollow) {
  const MadeSocket socket = BlockWithSocket(2);
  const SurfacePoints points = SampleSurface(socket.surface);
  const auto fit = FindSphere(points, {14, 32, /*is_hollow=*/true});
  ASSERT_TRUE(fit);
  EXPECT_LT((fit->sphere.center - socket.center).norm(), kHeadTolerance);
  EXPECT_NEAR(fit->sphere.radius, kMadeSocketRadius, kHeadTolerance);
  // The hollow is 22 mm deep, 22 / (2 * 26) of the sphere, less its rounded
  // rim.
  EXPECT_LT(fit->coverage, 22 / 52.0);
  EXPECT_GT(fit->coverage, 0.3);
  // It is no head.
  const auto head = FindSphere(points, {});
  EXPECT_TRUE(!head || (head->sphere.center - socket.center).norm() > 10);
}

TEST(FindSphere, FindsTheSphereOfTheLargestShareWithinTheRadii) {
  const SurfacePoints points =
      SampleSurface(Together(Icosphere(16, 3), SphereAt({80, 0, 0}, 28, 3)));
  const auto small = FindSphere(points, {12, 20, false});
  ASSERT_TRUE(small);
  EXPECT_LT(small->sphere.center.norm(), kHeadTolerance);
  const auto large = FindSphere(points, {22, 32, false});
  ASSERT_TRUE(large);
  EXPECT_LT((large->sphere.center - Eigen::Vector3d(80, 0, 0)).norm(),
            kHeadTolerance);
  // All of it, but for what triangles cut off.
  EXPECT_GT(large->coverage, 0.95);
  EXPECT_LT(large->coverage, 1.05);
}

TEST(FindSphere, CoversLittleOfABox) {
  const auto fit = FindSphere(SampleSurface(Box(120, 60, 40)), {});
  EXPECT_TRUE(!fit || fit->coverage < 0.2);
}

TEST(FindSphere, FindsNothingWithoutPoints) {
  EXPECT_FALSE(FindSphere(SampleSurface({}), {}));
}

}  // namespace
}  // namespace musclewarp
