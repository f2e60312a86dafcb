// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/folded_triangles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "support/meshes.h"

namespace musclewarp {

TEST(FoldedTriangles, NoneInRigidOrSmoothMotion) {
  const TriangleSoup spindle = Spindle(5, 30, 3);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(3, Eigen::Vector3d(1, 2, 3).normalized())
          .toRotationMatrix();
  Points moved = spindle.points * turn.transpose();
  moved.rowwise() += Eigen::RowVector3d(10, 20, 30);
  EXPECT_TRUE(
      FoldedTriangles(spindle.points, moved, spindle.triangles).empty());
  // Twisted by half a turn from end to end.
  for (Eigen::Index i = 0; i < moved.rows(); ++i) {
    moved.row(i) =
        spindle.points.row(i) *
        Eigen::AngleAxisd(spindle.points(i, 2) / 20, Eigen::Vector3d::UnitZ())
            .toRotationMatrix()
            .transpose();
  }
  EXPECT_TRUE(
      FoldedTriangles(spindle.points, moved, spindle.triangles).empty());
}

TEST(FoldedTriangles, FindsTheOnesAroundAPushedVertex) {
  const TriangleSoup sphere = Icosphere(10, 3);
  // A vertex slid across its far neighbours turns triangles around it over.
  Points pushed = sphere.points;
  const int vertex = sphere.triangles(100, 0);
  const int across = sphere.triangles(100, 1);
  pushed.row(vertex) +=
      2.5 * (sphere.points.row(across) - sphere.points.row(vertex));
  const std::vector<FoldedTriangle> folded =
      FoldedTriangles(sphere.points, pushed, sphere.triangles);
  EXPECT_GE(folded.size(), 1u);
  EXPECT_LE(folded.size(), 6u);
  for (const FoldedTriangle& triangle : folded) {
    EXPECT_TRUE(
        (sphere.triangles.row(triangle.triangle).array() == vertex).any());
  }
}

TEST(FoldedTriangles, NeedlesDoNotCount) {
  // The corner of a needle moved across its long edge by a rounding.
  TriangleSoup soup = UnitTetrahedron();
  soup.points.row(3) << 0.5, 1e-13, 0;
  Points moved = soup.points;
  moved(3, 1) = -1e-13;
  EXPECT_THAT(FoldedTriangles(soup.points, moved, soup.triangles),
              ::testing::IsEmpty());
}

}  // namespace musclewarp
