// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/initial_separation/marching_tetrahedra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "musclewarp/mesh/defects.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/proximity/mesh_intersection.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

constexpr double kRadius = 10;
const Box3 kBoxAroundBalls = {{-30, -30, -30}, {30, 30, 30}};

SignedDistanceFunction Ball(const RowVector3d& centre, double radius) {
  return [=](const RowVector3d& p) { return (p - centre).norm() - radius; };
}

int CrossingPairs(const TriangleSoup& a, const TriangleSoup& b) {
  return static_cast<int>(
      IntersectingTriangles(TriangleBvh(a.points, a.triangles),
                            TriangleBvh(b.points, b.triangles))
          .size());
}

// How much of the volume of a ball is missing.
double VolumeError(double spacing) {
  const TriangleSoup ball = MarchingTetrahedra(
      Ball({0.1, 0.2, 0.3}, kRadius), kBoxAroundBalls, spacing);
  const double volume = 4 * std::acos(-1.0) / 3 * std::pow(kRadius, 3);
  return 1 - SignedVolume(ball.points, ball.triangles) / volume;
}

}  // namespace

TEST(MarchingTetrahedra, MakeACleanSurfaceOfABall) {
  for (const double spacing : {0.5, 1.0, 3.0, 6.0}) {
    const RowVector3d centre(0.1, 0.2, 0.3);
    const TriangleSoup ball =
        MarchingTetrahedra(Ball(centre, kRadius), kBoxAroundBalls, spacing);
    EXPECT_TRUE(CountDefects(ball).IsClean()) << spacing;
    EXPECT_GT(SignedVolume(ball.points, ball.triangles), 0);
    EXPECT_TRUE(SelfIntersections(ball).empty()) << spacing;
    for (const auto p : ball.points.rowwise()) {
      EXPECT_NEAR((p - centre).norm(), kRadius, spacing);
    }
  }
}

TEST(MarchingTetrahedra, FindTheVolumeTheBetterTheFinerTheyAre) {
  // What is cut off falls with the square of the spacing.
  const double coarse = VolumeError(2), medium = VolumeError(1);
  const double fine = VolumeError(0.5);
  EXPECT_GT(fine, 0);
  EXPECT_LT(coarse, 0.025);
  EXPECT_NEAR(coarse / medium, 4, 0.4);
  EXPECT_NEAR(medium / fine, 4, 0.4);
}

TEST(MarchingTetrahedra, MakeACleanSurfaceWhereValuesAreZeroAtSamples) {
  // The faces of the cube pass through samples.
  const TriangleSoup cube = MarchingTetrahedra(
      [](const RowVector3d& p) { return p.cwiseAbs().maxCoeff() - 6; },
      kBoxAroundBalls,
      2);
  EXPECT_TRUE(CountDefects(cube).IsClean());
  EXPECT_TRUE(SelfIntersections(cube).empty());
}

TEST(MarchingTetrahedra, TwoRegionsThatDoNotOverlapHaveSurfacesThatDoNotCross) {
  // The common border of two balls that overlap, a hair's breadth apart: the
  // functions add up to that at every place.
  constexpr double kApart = 1e-6;
  const auto a = Ball({-5.3, 0.7, 0.2}, kRadius);
  const auto b = Ball({5.1, -0.4, 1.3}, 8);
  const auto of_a = [&](const RowVector3d& p) {
    return std::max(a(p), (a(p) - b(p) + kApart) / 2);
  };
  const auto of_b = [&](const RowVector3d& p) {
    return std::max(b(p), (b(p) - a(p) + kApart) / 2);
  };
  for (const double spacing : {0.7, 1.0, 2.5, 5.0}) {
    const TriangleSoup one = MarchingTetrahedra(of_a, kBoxAroundBalls, spacing);
    const TriangleSoup two = MarchingTetrahedra(of_b, kBoxAroundBalls, spacing);
    ASSERT_GT(one.triangles.rows(), 0);
    ASSERT_GT(two.triangles.rows(), 0);
    EXPECT_EQ(CrossingPairs(one, two), 0) << spacing;
    EXPECT_TRUE(SelfIntersections(one).empty()) << spacing;
    EXPECT_TRUE(IntersectMeshes(one, two).IsEmpty()) << spacing;
  }
}

TEST(MarchingTetrahedra, SurfacesDoNotTouchWhereTheyMeetNearSamples) {
  // Two parts of a ball with a gap beside a plane of samples: both surfaces
  // have vertices near the same ends of the same edges.
  const auto ball = Ball({0, 0, 0}, kRadius);
  for (const double spacing : {0.7, 1.0, 1.3, 2.0, 3.0}) {
    for (int axis = 0; axis < 3; ++axis) {
      const double plane = spacing * 2;
      const TriangleSoup above = MarchingTetrahedra(
          [&](const RowVector3d& p) {
            return std::max(ball(p), plane + 0.01 - p[axis]);
          },
          kBoxAroundBalls,
          spacing);
      const TriangleSoup below = MarchingTetrahedra(
          [&](const RowVector3d& p) {
            return std::max(ball(p), p[axis] - plane - 0.005);
          },
          kBoxAroundBalls,
          spacing);
      ASSERT_GT(above.triangles.rows(), 0);
      ASSERT_GT(below.triangles.rows(), 0);
      EXPECT_EQ(CrossingPairs(above, below), 0) << spacing << " " << axis;
    }
  }
}

TEST(MarchingTetrahedra, TwoBodiesAreTwoComponents) {
  const auto a = Ball({-12, 0, 0}, kRadius), b = Ball({12, 0, 0}, kRadius);
  const TriangleSoup both = MarchingTetrahedra(
      [&](const RowVector3d& p) { return std::min(a(p), b(p)); },
      kBoxAroundBalls,
      1);
  const MeshDefects defects = CountDefects(both);
  EXPECT_TRUE(defects.is_closed_manifold);
  EXPECT_EQ(defects.components, 2);
  EXPECT_EQ(defects.misoriented_edges, 0);
}

TEST(MarchingTetrahedra, AnEmptyRegionHasNoSurface) {
  const TriangleSoup nothing = MarchingTetrahedra(
      [](const RowVector3d& p) { return p.norm() + 1; }, kBoxAroundBalls, 1);
  EXPECT_EQ(nothing.points.rows(), 0);
  EXPECT_EQ(nothing.triangles.rows(), 0);
}

}  // namespace musclewarp
