// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/element_improvement.h"

#include <gtest/gtest.h>

#include "exchange/star_mesh.h"
#include "musclewarp/exchange/sharp_points.h"
#include "musclewarp/mesh/measures.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

// Of sums of some thousand volumes, relative.
constexpr double kVolumeDigits = 1e-12;

// A ball whose elements have their common corner next to its surface.
TetrahedralMesh BadMesh(const TriangleSoup& ball) {
  TetrahedralMesh mesh;
  mesh.points = ball.points;
  AddStar(ball.triangles, 0, {0, 0, 9.9}, &mesh);
  return mesh;
}

TEST(ImproveElements, MakesSmallAnglesLargerAndKeepsTheSurface) {
  const TriangleSoup ball = Icosphere(10, 3);
  const TetrahedralMesh before = BadMesh(ball);
  ASSERT_EQ(QualityOf(before).inverted, 0);
  TetrahedralMesh mesh = before;
  ImproveElements(12, ball.points.rows(), &mesh);
  const ElementQuality quality = QualityOf(mesh);
  EXPECT_GT(QualityOf(before).small_angles, 20);
  EXPECT_EQ(quality.small_angles, 0);
  EXPECT_EQ(quality.inverted, 0);
  EXPECT_EQ(mesh.points.topRows(ball.points.rows()), ball.points);
  EXPECT_EQ(BorderFaces(mesh.tetrahedra, ball.triangles).size(),
            static_cast<size_t>(ball.triangles.rows()));
  EXPECT_NEAR(quality.volume / SignedVolume(ball.points, ball.triangles),
              1,
              kVolumeDigits);
}

// An improvement is one whatever the place, the size and the side of the body.
TEST(ImproveElements, DoesTheSameAtAnotherSize) {
  const TriangleSoup ball = Icosphere(10, 3);
  TetrahedralMesh mesh = BadMesh(ball), large = mesh;
  // A power of two changes no digit.
  large.points *= 1024;
  ImproveElements(12, ball.points.rows(), &mesh);
  ImproveElements(12, ball.points.rows(), &large);
  EXPECT_EQ(mesh.tetrahedra, large.tetrahedra);
  EXPECT_EQ(1024 * mesh.points, large.points);
}

TEST(ImproveElements, LeavesGoodElementsAlone) {
  const TriangleSoup ball = Icosphere(10, 1);
  const TetrahedralMesh before = StarMesh(ball);
  ASSERT_GT(QualityOf(before).smallest_dihedral_deg, 12);
  TetrahedralMesh mesh = before;
  ImproveElements(12, ball.points.rows(), &mesh);
  EXPECT_EQ(mesh.points, before.points);
  EXPECT_EQ(mesh.tetrahedra, before.tetrahedra);
}

// A surface that is sharper than the goal allows no better; the rest improves.
TEST(ImproveElements, SmallAnglesThatStayAreWhereTheSurfaceIsSharp) {
  TriangleSoup lens = Icosphere(10, 2);
  lens.points.col(2) *= 0.03;
  TetrahedralMesh mesh = StarMesh(lens);
  ImproveElements(12, lens.points.rows(), &mesh);
  const ElementQuality quality = QualityOf(mesh, SharpPoints(lens));
  EXPECT_EQ(quality.inverted, 0);
  EXPECT_LE(quality.small_angles_at_sharp, quality.small_angles);
  EXPECT_GT(quality.small_angles_at_sharp, 0);
}

}  // namespace
}  // namespace musclewarp
