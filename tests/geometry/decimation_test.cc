// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/decimation.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

#include "musclewarp/mesh/defects.h"
#include "musclewarp/proximity/triangle_bvh.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

TEST(Decimated, HasFewTrianglesNearTheSurface) {
  const TriangleSoup ball = Icosphere(50, 5);
  const Decimation view = Decimated(ball, {1000});
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

TEST(Decimated, LeavesSmallMeshesAlone) {
  const TriangleSoup ball = Icosphere(50, 2);
  const Decimation view = Decimated(ball, {1000});
  EXPECT_EQ(view.soup.points, ball.points);
  EXPECT_EQ(view.soup.triangles, ball.triangles);
  EXPECT_EQ(view.max_error, 0);
}

TEST(Decimated, LeavesWhatIsNoManifoldAlone) {
  TriangleSoup ball = Icosphere(50, 3);
  ball.triangles.conservativeResize(ball.triangles.rows() + 1, 3);
  ball.triangles.bottomRows(1) = ball.triangles.topRows(1);
  const Decimation view = Decimated(ball, {100});
  EXPECT_EQ(view.soup.triangles, ball.triangles);
}

// What is kept stays to the bit, and the rest within the tolerance.
TEST(Decimated, KeepsWhatItIsToldAndTheTolerance) {
  const TriangleSoup ball = Icosphere(50, 5);
  DecimationOptions options;
  options.tolerance = 0.1;
  for (Eigen::Index v = 0; v < ball.points.rows(); ++v) {
    options.is_kept.push_back(ball.points(v, 2) > 20);
  }
  const Decimation result = Decimated(ball, options);
  EXPECT_TRUE(CountDefects(result.soup).IsClean());
  EXPECT_LT(result.soup.triangles.rows(), 0.6 * ball.triangles.rows());
  EXPECT_LE(result.max_error, options.tolerance);
  ASSERT_EQ(result.vertices.size(),
            static_cast<size_t>(result.soup.points.rows()));
  for (size_t v = 0; v < result.vertices.size(); ++v) {
    EXPECT_EQ(result.soup.points.row(v), ball.points.row(result.vertices[v]));
  }
  std::set<std::array<double, 3>> points;
  for (const auto& p : result.soup.points.rowwise()) {
    points.insert({p[0], p[1], p[2]});
  }
  for (const auto& p : ball.points.rowwise()) {
    if (p[2] <= 20) continue;
    EXPECT_EQ(points.count({p[0], p[1], p[2]}), 1u);
  }
}

}  // namespace
}  // namespace musclewarp
