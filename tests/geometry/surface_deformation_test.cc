// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/surface_deformation.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "support/meshes.h"

namespace musclewarp {
namespace {

// Sums of a dozen products of edges of about 1 to 10 mm.
constexpr double kStretchRounding = 1e-12;

// A flat sheet of squares of two triangles each, in the plane z = 0, with edges
// of 1 mm.
TriangleSoup Sheet(int size) {
  TriangleSoup sheet;
  sheet.points.resize((size + 1) * (size + 1), 3);
  sheet.triangles.resize(2 * size * size, 3);
  for (int y = 0; y <= size; ++y) {
    for (int x = 0; x <= size; ++x) {
      sheet.points.row(y * (size + 1) + x) << x, y, 0;
    }
  }
  for (int y = 0, f = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const int a = y * (size + 1) + x, b = a + size + 1;
      sheet.triangles.row(f++) << a, a + 1, b + 1;
      sheet.triangles.row(f++) << a, b + 1, b;
    }
  }
  return sheet;
}

Points Course(const TriangleSoup& mesh, const Eigen::RowVector3d& direction) {
  return direction.replicate(mesh.points.rows(), 1);
}

TEST(SurfaceDeformation, RigidMotionsStretchAndBendNothing) {
  const TriangleSoup mesh = Icosphere(10, 3);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, -1).normalized())
          .toRotationMatrix();
  const Points moved = (mesh.points * turn.transpose()).rowwise() +
                       Eigen::RowVector3d(5, -7, 100);
  const SurfaceDeformation result =
      SurfaceAtRest(mesh.points, mesh.triangles, Course(mesh, {0, 0, 1}))
          .Measure(moved);
  for (const Eigen::VectorXd& ratios : {result.largest_stretch,
                                        result.stretch_along,
                                        result.stretch_across,
                                        result.area_ratio}) {
    EXPECT_LT((ratios.array() - 1).abs().maxCoeff(), kStretchRounding);
  }
  // Positions of 100 mm are rounded by 1e-14, edges of 1 mm turn by as much.
  EXPECT_LT(result.bend.maxCoeff(), 1e-11);
}

TEST(SurfaceDeformation, LinearMapsOfAPlaneAreFoundExactly) {
  const TriangleSoup sheet = Sheet(4);
  Points stretched = sheet.points;
  stretched.col(0) *= 1.5;
  stretched.col(1) *= 0.8;
  const SurfaceDeformation result =
      SurfaceAtRest(sheet.points, sheet.triangles, Course(sheet, {3, 0, 0}))
          .Measure(stretched);
  for (Eigen::Index v = 0; v < sheet.points.rows(); ++v) {
    EXPECT_NEAR(result.largest_stretch[v], 1.5, kStretchRounding);
    EXPECT_NEAR(result.stretch_along[v], 1.5, kStretchRounding);
    EXPECT_NEAR(result.stretch_across[v], 0.8, kStretchRounding);
    EXPECT_NEAR(result.area_ratio[v], 1.2, kStretchRounding);
    EXPECT_NEAR(result.bend[v], 0, kStretchRounding);
  }
}

TEST(SurfaceDeformation, ShearStretchesBetweenTheAxes) {
  const TriangleSoup sheet = Sheet(3);
  constexpr double kShear = 1;
  Points sheared = sheet.points;
  sheared.col(0) += kShear * sheared.col(1);
  const SurfaceDeformation result =
      SurfaceAtRest(sheet.points, sheet.triangles, Course(sheet, {1, 0, 0}))
          .Measure(sheared);
  // The larger singular value of [1 1; 0 1] is the golden ratio.
  const double golden = (1 + std::sqrt(5.0)) / 2;
  EXPECT_NEAR(result.largest_stretch[5], golden, kStretchRounding);
  EXPECT_NEAR(result.stretch_along[5], 1, kStretchRounding);
  EXPECT_NEAR(result.stretch_across[5], std::sqrt(2.0), kStretchRounding);
  EXPECT_NEAR(result.area_ratio[5], 1, kStretchRounding);
}

TEST(SurfaceDeformation, WithoutACourseNothingIsAlongOrAcross) {
  const TriangleSoup sheet = Sheet(2);
  const SurfaceDeformation result =
      SurfaceAtRest(sheet.points, sheet.triangles, Points())
          .Measure(2 * sheet.points);
  EXPECT_NEAR(result.largest_stretch.minCoeff(), 2, kStretchRounding);
  EXPECT_EQ(result.stretch_along.maxCoeff(), 1);
  EXPECT_EQ(result.stretch_across.maxCoeff(), 1);
}

TEST(SurfaceDeformation, ARolledSheetBendsByTheAngleOfItsEdges) {
  const TriangleSoup sheet = Sheet(6);
  constexpr double kRadius = 5;
  Points rolled = sheet.points;
  for (Eigen::Index v = 0; v < rolled.rows(); ++v) {
    const double angle = sheet.points(v, 0) / kRadius;
    rolled(v, 0) = kRadius * std::sin(angle);
    rolled(v, 2) = -kRadius * (1 - std::cos(angle));
  }
  const SurfaceDeformation convex =
      SurfaceAtRest(sheet.points, sheet.triangles, Points()).Measure(rolled);
  // In the middle, the normals of neighbours are turned by an edge of 1 mm on
  // the radius; weights of triangles shift that by some per cent.
  constexpr int kMiddle = 3 * 7 + 3;
  EXPECT_NEAR(convex.bend[kMiddle], 1 / kRadius, 0.05 / kRadius);
  // From one side to the other it bends twice as far.
  Points other = rolled;
  other.col(2) *= -1;
  const SurfaceDeformation turned =
      SurfaceAtRest(rolled, sheet.triangles, Points()).Measure(other);
  EXPECT_NEAR(turned.bend[kMiddle], 2 * convex.bend[kMiddle], 1e-9);
}

TEST(SurfaceDeformation, VerticesWithoutAreaCountAsRigid) {
  TriangleSoup needle;
  needle.points.resize(3, 3);
  needle.points << 0, 0, 0, 1, 0, 0, 2, 0, 0;
  needle.triangles.resize(1, 3);
  needle.triangles << 0, 1, 2;
  const SurfaceDeformation result =
      SurfaceAtRest(needle.points, needle.triangles, Points())
          .Measure(3 * needle.points);
  EXPECT_EQ(result.largest_stretch.maxCoeff(), 1);
  EXPECT_TRUE(result.bend.allFinite());
}

}  // namespace
}  // namespace musclewarp
