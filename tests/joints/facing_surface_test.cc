// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/facing_surface.h"

#include <gtest/gtest.h>

#include "joints/ideal_surfaces.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

// Points a millimetre apart on a square in a plane of constant z, with normals
// that point up or down.
SurfacePoints Plate(double z, double up) {
  SurfacePoints plate;
  plate.points.resize(441, 3);
  plate.normals.setZero(441, 3);
  plate.normals.col(2).setConstant(up);
  for (int row = 0; row < 21; ++row) {
    for (int column = 0; column < 21; ++column) {
      plate.points.row(21 * row + column) << column, row, z;
    }
  }
  plate.area = 1;
  return plate;
}

SurfacePoints TurnedInward(SurfacePoints surface) {
  surface.normals *= -1;
  return surface;
}

TEST(FacingSurface, IsAllOfTwoPlatesThreeMillimetresApart) {
  EXPECT_EQ(FacingSurface(Plate(0, 1), Plate(3, -1)).size(), 441);
  EXPECT_EQ(FacingSurface(Plate(3, -1), Plate(0, 1)).size(), 441);
}

TEST(FacingSurface, IsNothingOfPlatesOutOfReach) {
  EXPECT_EQ(FacingSurface(Plate(0, 1), Plate(6.01, -1)).size(), 0);
  EXPECT_EQ(FacingSurface(Plate(0, 1), Plate(8, -1)).size(), 0);
  FacingLimits limits;
  limits.reach = 8.5;
  EXPECT_EQ(FacingSurface(Plate(0, 1), Plate(8, -1), limits).size(), 441);
}

TEST(FacingSurface, IsNothingOfPlatesBackToBack) {
  EXPECT_EQ(FacingSurface(Plate(0, -1), Plate(3, 1)).size(), 0);
  // One behind the other, looking the same way.
  EXPECT_EQ(FacingSurface(Plate(0, 1), Plate(3, 1)).size(), 0);
  EXPECT_EQ(FacingSurface(Plate(3, 1), Plate(0, 1)).size(), 0);
}

TEST(FacingSurface, EndsWhereTheOtherPlateEnds) {
  SurfacePoints shifted = Plate(3, -1);
  shifted.points.col(0).array() += 10;
  const SurfacePoints facing = FacingSurface(Plate(0, 1), shifted);
  // Beside it by up to 3 mm the way to its edge is within 45 degrees, of which
  // the cosine is above 0.7; at 4 mm it is not.
  EXPECT_EQ(facing.points.col(0).minCoeff(), 10 - 3);
  EXPECT_EQ(facing.size(), 14 * 21);
}

TEST(FacingSurface, IsAllOfABallInAShellThreeMillimetresOff) {
  // So many points that neighbours are about 1.2 mm apart.
  const Eigen::Vector3d center(10, -4, 7);
  const SurfacePoints ball = IdealSphere(center, 20, 3500);
  const SurfacePoints near = TurnedInward(IdealSphere(center, 23, 4600));
  const SurfacePoints far = TurnedInward(IdealSphere(center, 28, 6800));
  EXPECT_EQ(FacingSurface(ball, near).size(), ball.size());
  EXPECT_EQ(FacingSurface(near, ball).size(), near.size());
  EXPECT_EQ(FacingSurface(ball, far).size(), 0);
  EXPECT_EQ(FacingSurface(ball, IdealSphere(center, 23, 4600)).size(), 0);
}

TEST(FacingSurface, IsTheSideOfABoxThatLooksAtTheOther) {
  const SurfacePoints lower = SampleSurface(Box(40, 40, 10));
  const SurfacePoints upper =
      SampleSurface(MovedBy(Box(40, 40, 10), {0, 0, 13}));
  const SurfacePoints facing = FacingSurface(lower, upper);
  // Near the edges normals are averaged with those of the sides, so that a rim
  // of at most 2.5 mm may be missing, or face the other too.
  EXPECT_GT(facing.size() * facing.area, 35 * 35);
  EXPECT_LT(facing.size() * facing.area, 40 * 40 + 4 * 40 * 2.5);
  EXPECT_GT(facing.points.col(2).minCoeff(), 5 - 2.5);
  EXPECT_EQ(facing.area, lower.area);
}

TEST(FacingSurface, IsNothingWithoutTheOther) {
  EXPECT_EQ(FacingSurface(Plate(0, 1), {}).size(), 0);
  EXPECT_EQ(FacingSurface({}, Plate(0, 1)).size(), 0);
}

}  // namespace
}  // namespace musclewarp
