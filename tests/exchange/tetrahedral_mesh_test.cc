// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/tetrahedral_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "exchange/star_mesh.h"
#include "musclewarp/base/angles.h"
#include "musclewarp/mesh/measures.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

// Rounding of angles in degrees and of volumes relative to themselves.
constexpr double kVolumeRounding = 1e-12;

TetrahedralMesh OneElement(const Points& corners) {
  TetrahedralMesh mesh;
  mesh.points = corners;
  mesh.tetrahedra.resize(1, 4);
  mesh.tetrahedra << 0, 1, 2, 3;
  return mesh;
}

TEST(QualityOf, ARegularElementIsBest) {
  const ElementQuality quality = QualityOf(
      OneElement(Points{{1, 1, 1}, {-1, 1, -1}, {1, -1, -1}, {-1, -1, 1}}));
  const double angle = DegreesOf(std::acos(1.0 / 3));
  EXPECT_NEAR(quality.smallest_dihedral_deg, angle, 1e-10);
  EXPECT_NEAR(quality.largest_dihedral_deg, angle, 1e-10);
  EXPECT_NEAR(quality.largest_aspect, 1, kVolumeRounding);
  EXPECT_NEAR(quality.volume, 8.0 / 3, kVolumeRounding);
  EXPECT_EQ(quality.inverted, 0);
}

TEST(QualityOf, ACornerOfACubeHasRightAngles) {
  const TriangleSoup corner = UnitTetrahedron();
  const ElementQuality quality = QualityOf(OneElement(corner.points));
  EXPECT_NEAR(quality.largest_dihedral_deg, 90, 1e-10);
  EXPECT_NEAR(quality.smallest_dihedral_deg,
              DegreesOf(std::acos(1 / std::sqrt(3))),
              1e-10);
  EXPECT_NEAR(quality.volume, 1.0 / 6, kVolumeRounding);
}

TEST(QualityOf, CountsInvertedElements) {
  TetrahedralMesh mesh = OneElement(UnitTetrahedron().points);
  std::swap(mesh.points(3, 2), mesh.points(0, 2));  // flat
  mesh.points(3, 2) = 0;
  mesh.points(0, 2) = 0;
  EXPECT_EQ(QualityOf(mesh).inverted, 1);
  EXPECT_EQ(QualityOf(mesh).largest_aspect,
            std::numeric_limits<double>::infinity());
  mesh.points(3, 2) = -1;
  EXPECT_EQ(QualityOf(mesh).inverted, 1);
  EXPECT_LT(QualityOf(mesh).volume, 0);
}

TEST(Volumes, AddUpToThatOfTheSurface) {
  const TriangleSoup ball = Icosphere(10, 3);
  const TetrahedralMesh mesh = StarMesh(ball);
  const double volume = SignedVolume(ball.points, ball.triangles);
  EXPECT_GT(Volumes(mesh).minCoeff(), 0);
  EXPECT_NEAR(Volumes(mesh).sum() / volume, 1, kVolumeRounding);
}

TEST(BorderFaces, AreTheTrianglesOfTheSurface) {
  const TriangleSoup ball = Icosphere(10, 1);
  const TetrahedralMesh mesh = StarMesh(ball);
  const auto faces = BorderFaces(mesh.tetrahedra, ball.triangles);
  ASSERT_EQ(faces.size(), static_cast<size_t>(ball.triangles.rows()));
  for (size_t f = 0; f < faces.size(); ++f) {
    Points corners(3, 3), expected(3, 3);
    for (int k = 0; k < 3; ++k) {
      const int v =
          mesh.tetrahedra(faces[f].tetrahedron, kFaceCorners[faces[f].face][k]);
      corners.row(k) = mesh.points.row(v);
      expected.row(k) = ball.points.row(ball.triangles(f, k));
    }
    const auto normal = [](const Points& t) {
      const Eigen::RowVector3d u = t.row(1) - t.row(0), v = t.row(2) - t.row(0);
      return Eigen::RowVector3d(u.cross(v));
    };
    EXPECT_EQ(corners.colwise().sum(), expected.colwise().sum());
    EXPECT_GT(normal(corners).dot(normal(expected)), 0);  // both outward
  }
}

TEST(BorderFaces, AreNoneIfTheSurfaceIsAnother) {
  const TriangleSoup ball = Icosphere(10, 1);
  TetrahedralMesh mesh = StarMesh(ball);
  const Triangles fewer = ball.triangles.topRows(ball.triangles.rows() - 1);
  EXPECT_TRUE(BorderFaces(mesh.tetrahedra, fewer).empty());
  mesh.tetrahedra.conservativeResize(mesh.tetrahedra.rows() - 1, 4);
  EXPECT_TRUE(BorderFaces(mesh.tetrahedra, ball.triangles).empty());
  Triangles other = ball.triangles;
  other(0, 0) = other(5, 1);
  EXPECT_TRUE(BorderFaces(StarMesh(ball).tetrahedra, other).empty());
}

}  // namespace
}  // namespace musclewarp
