// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh/measures.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/meshes.h"

namespace musclewarp {

// Sums of a few hundred terms of size 1e3: rounding stays below 1e-12 of that.
constexpr double kRounding = 1e-12;

TEST(Measures, VolumeAndAreaOfABox) {
  const TriangleSoup box = Box(2, 3, 4);
  EXPECT_DOUBLE_EQ(SignedVolume(box.points, box.triangles), 24);
  EXPECT_DOUBLE_EQ(SurfaceArea(box.points, box.triangles), 52);
  EXPECT_DOUBLE_EQ(BoundingBoxDiagonal(box.points), std::sqrt(29.0));
}

// Of a box it is pi times the sum of its three edges, whatever diagonals its
// sides have; of a sphere 4 pi r.
TEST(Measures, MeanCurvatureOfABoxAndASphere) {
  const TriangleSoup box = Box(2, 3, 4);
  EXPECT_NEAR(
      MeanCurvatureIntegral(box.points, box.triangles), M_PI * 9, 1e-12);
  const TriangleSoup sphere = Icosphere(10, 4);
  EXPECT_NEAR(MeanCurvatureIntegral(sphere.points, sphere.triangles),
              4 * M_PI * 10,
              1e-2 * 4 * M_PI * 10);  // edges of a tenth of the radius
  // A dent is as concave from inside as it is convex from outside.
  TriangleSoup inside = sphere;
  inside.triangles.col(0).swap(inside.triangles.col(1));
  EXPECT_NEAR(MeanCurvatureIntegral(inside.points, inside.triangles),
              -MeanCurvatureIntegral(sphere.points, sphere.triangles),
              1e-9);
}

// Whatever the mesh, the areas of the vertices are that of the surface, and a
// vertex without triangles has none.
TEST(Measures, VerticesShareTheAreaOfTheirTriangles) {
  TriangleSoup sphere = Icosphere(10, 2);
  sphere.points.conservativeResize(sphere.points.rows() + 1, 3);
  sphere.points.bottomRows<1>().setZero();
  const Eigen::VectorXd areas = VertexAreas(sphere.points, sphere.triangles);
  const double area = SurfaceArea(sphere.points, sphere.triangles);
  EXPECT_NEAR(areas.sum(), area, 1e-12 * area);  // rounding of a sum
  EXPECT_EQ(areas.tail<1>()[0], 0);
  const TriangleSoup tetrahedron = UnitTetrahedron();
  const Eigen::VectorXd even =
      VertexAreas(tetrahedron.points, tetrahedron.triangles);
  // Three right angled triangles of area 1/2 meet at the origin.
  EXPECT_DOUBLE_EQ(even.maxCoeff(), (1 + std::sqrt(3.0) / 2) / 3);
  EXPECT_DOUBLE_EQ(even.minCoeff(), 0.5);
}

TEST(Measures, NeighboursOfOneOrientationPassTheirEdgeInBothDirections) {
  const Triangles box = Box(2, 3, 4).triangles;
  EXPECT_TRUE(IsConsistentlyOriented(box));
  EXPECT_TRUE(IsConsistentlyOriented(box.topRows(box.rows() - 1)));  // open
  Triangles turned = box;
  EXPECT_TRUE(
      IsConsistentlyOriented(turned.rowwise().reverse()));  // inside out
  turned.row(0).reverseInPlace();
  EXPECT_FALSE(IsConsistentlyOriented(turned));
  // Every triangle twice, and then one of them the other way.
  Triangles twice(2 * box.rows(), 3);
  twice << box, box;
  EXPECT_TRUE(IsConsistentlyOriented(twice));
  twice.row(0).reverseInPlace();
  EXPECT_FALSE(IsConsistentlyOriented(twice));
}

TEST(Measures, VolumeIsNegativeInsideOut) {
  TriangleSoup tetrahedron = UnitTetrahedron();
  tetrahedron.triangles.col(0).swap(tetrahedron.triangles.col(1));
  EXPECT_DOUBLE_EQ(SignedVolume(tetrahedron.points, tetrahedron.triangles),
                   -1.0 / 6);
}

TEST(Measures, VolumeDoesNotDependOnThePlace) {
  TriangleSoup sphere = Icosphere(10, 3);
  const double volume = SignedVolume(sphere.points, sphere.triangles);
  sphere.points.rowwise() += Eigen::RowVector3d(300, -200, 1000);
  // Coordinates of 1e3 carry an absolute rounding of 1e-13, times area 1e3.
  EXPECT_NEAR(SignedVolume(sphere.points, sphere.triangles), volume, 1e-9);
}

TEST(Measures, GradientIsTheNumericDerivative) {
  TriangleSoup spindle = Spindle(5, 20, 1);
  const Points gradient = VolumeGradient(spindle.points, spindle.triangles);
  for (Eigen::Index i = 0; i < spindle.points.size(); ++i) {
    double& x = spindle.points.data()[i];
    const double x0 = x;
    // The volume is linear in one coordinate: central differences are exact.
    x = x0 + 1;
    const double plus = SignedVolume(spindle.points, spindle.triangles);
    x = x0 - 1;
    const double minus = SignedVolume(spindle.points, spindle.triangles);
    x = x0;
    EXPECT_NEAR(gradient.data()[i], (plus - minus) / 2, 1e3 * kRounding);
  }
}

TEST(Measures, RateOfTheGradientIsItsDifference) {
  const TriangleSoup spindle = Spindle(5, 20, 1);
  const Points velocities = Points::Random(spindle.points.rows(), 3);
  // The gradient is quadratic in the points: central differences are exact.
  const Points difference =
      (VolumeGradient(spindle.points + velocities, spindle.triangles) -
       VolumeGradient(spindle.points - velocities, spindle.triangles)) /
      2;
  const Points rate =
      VolumeGradientRate(spindle.points, velocities, spindle.triangles);
  EXPECT_GT(difference.norm(), 1);
  EXPECT_LT((rate - difference).norm(), 1e3 * kRounding);
}

TEST(Measures, GradientSumsToZeroAndGivesThriceTheVolume) {
  const TriangleSoup sphere = Icosphere(10, 3);
  const Points gradient = VolumeGradient(sphere.points, sphere.triangles);
  EXPECT_LT(gradient.colwise().sum().norm(), 1e3 * kRounding);
  EXPECT_NEAR(gradient.cwiseProduct(sphere.points).sum(),
              3 * SignedVolume(sphere.points, sphere.triangles),
              1e4 * kRounding);
}

TEST(TypicalEdge, IsTheEdgeOfEquilateralTriangles) {
  Points points(4, 3);
  points << 0, 0, 0, 1, 1, 0, 1, 0, 1, 0, 1, 1;
  Triangles triangles(4, 3);
  triangles << 0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2;
  EXPECT_DOUBLE_EQ(TypicalEdge(points, triangles), std::sqrt(2.0));
}

}  // namespace musclewarp
