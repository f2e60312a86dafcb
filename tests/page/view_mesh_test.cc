// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/page/view_mesh.h"

#include <gtest/gtest.h>

#include "musclewarp/mesh/defects.h"
#include "musclewarp/proximity/triangle_bvh.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

TEST(ViewMesh, HasFewTrianglesNearTheSurface) {
  const TriangleSoup ball = Icosphere(50, 5);
  const ViewMesh view = ViewMeshOf(ball, 1000);
  EXPECT_LE(view.soup.triangles.rows(), 1000);
  EXPECT_GE(view.soup.triangles.rows(), 900);
  EXPECT_TRUE(CountDefects(view.soup).IsClean());
  // A thousand triangles on a ball of 50 mm have edges of 8.5 mm; one twice as
  // long leaves the ball by e^2 / (8 r) = 0.72 mm.
  EXPECT_LT(view.max_error, 0.72);
  const TriangleBvh surface(view.soup.points, view.soup.triangles);
  double farthest = 0;
  for (Eigen::Index v = 0; v < ball.points.rows(); ++v) {
    farthest =
        std::max(farthest, surface.ClosestPoint(ball.points.row(v)).distance);
  }
  EXPECT_EQ(view.max_error, farthest);
}

TEST(ViewMesh, LeavesSmallMeshesAlone) {
  const TriangleSoup ball = Icosphere(50, 2);
  const ViewMesh view = ViewMeshOf(ball, 1000);
  EXPECT_EQ(view.soup.points, ball.points);
  EXPECT_EQ(view.soup.triangles, ball.triangles);
  EXPECT_EQ(view.max_error, 0);
}

TEST(ViewMesh, LeavesWhatIsNoManifoldAlone) {
  TriangleSoup ball = Icosphere(50, 3);
  ball.triangles.conservativeResize(ball.triangles.rows() + 1, 3);
  ball.triangles.bottomRows(1) = ball.triangles.topRows(1);
  const ViewMesh view = ViewMeshOf(ball, 100);
  EXPECT_EQ(view.soup.triangles, ball.triangles);
}

}  // namespace
}  // namespace musclewarp
