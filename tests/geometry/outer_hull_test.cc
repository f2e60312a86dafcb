// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/outer_hull.h"

#include <gtest/gtest.h>

#include "musclewarp/mesh/defects.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/proximity/mesh_intersection.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

// A bent muscle, far from the origin.
TriangleSoup Muscle() {
  TriangleSoup muscle = Spindle(20, 90, 3);
  muscle.points.col(0) +=
      muscle.points.col(2).cwiseProduct(muscle.points.col(2)) / 200;
  muscle.points.rowwise() += Eigen::RowVector3d(180, 270, -400);
  return muscle;
}

using Eigen::RowVector3d;

}  // namespace

TEST(OuterHull, DefaultOptionsAreValid) {
  std::string error;
  EXPECT_TRUE(OuterHullOptions().IsValid(&error)) << error;
}

TEST(OuterHull, IsACleanMeshAroundTheMuscle) {
  const TriangleSoup muscle = Muscle();
  for (const int wanted : {60, 200, 600}) {
    OuterHullOptions options;
    options.coarse_vertices = wanted;
    const TriangleSoup hull = OuterHull(muscle, options);
    EXPECT_TRUE(CountDefects(hull).IsClean());
    EXPECT_TRUE(Encloses(hull, muscle));
    EXPECT_NEAR(hull.points.rows(), wanted, 0.2 * wanted);
    EXPECT_LT(SignedVolume(hull.points, hull.triangles),
              2 * SignedVolume(muscle.points, muscle.triangles));
  }
}

// All vertices of a wrap are at its distance from a convex surface.
TEST(OuterHull, KeepsItsDistanceWhateverTheNumberOfItsVertices) {
  constexpr double kRadius = 50;
  const TriangleSoup ball = Icosphere(kRadius, 4);
  OuterHullOptions options;
  const double distance = options.relative_distance *
                          std::sqrt(SurfaceArea(ball.points, ball.triangles));
  for (const int wanted : {150, 500}) {
    options.coarse_vertices = wanted;
    const Eigen::VectorXd radii =
        OuterHull(ball, options).points.rowwise().norm();
    // The ball is a polyhedron, whose faces are up to 0.1 mm inside.
    EXPECT_NEAR(radii.minCoeff(), kRadius + distance, 0.15);
    EXPECT_NEAR(radii.maxCoeff(), kRadius + distance, 0.15);
  }
}

TEST(OuterHull, TakesDirtyMeshes) {
  TriangleSoup muscle = Muscle();
  // A hole, a doubled triangle, a triangle without area, an unused point.
  muscle.triangles.conservativeResize(muscle.triangles.rows() - 4, 3);
  muscle.triangles.row(0) = muscle.triangles.row(1).eval();
  muscle.triangles(2, 1) = muscle.triangles(2, 0);
  muscle.points.conservativeResize(muscle.points.rows() + 1, 3);
  muscle.points.bottomRows<1>().setConstant(1e4);
  const TriangleSoup hull = OuterHull(muscle, {});
  EXPECT_TRUE(CountDefects(hull).IsClean());
  EXPECT_TRUE(Encloses(hull, muscle));
}

TEST(OuterHull, StrayPiecesFarAwayAreLeftOut) {
  const TriangleSoup fine = Spindle(20, 60, 3);
  const TriangleSoup hull =
      OuterHull(Together(fine, MovedBy(Box(1, 1, 1), {500, 0, 0})), {});
  EXPECT_TRUE(CountDefects(hull).IsClean());
  EXPECT_TRUE(SelfIntersections(hull).empty());
  EXPECT_TRUE(Encloses(hull, fine));
}

TEST(OuterHull, DoesNotDependOnTheRun) {
  EXPECT_EQ(OuterHull(Muscle(), {}).points, OuterHull(Muscle(), {}).points);
}

TEST(Encloses, NeedsVerticesEdgesAndFacesInside) {
  const TriangleSoup hull = Box(10, 10, 10);
  TriangleSoup inner = Icosphere(4, 2);
  EXPECT_TRUE(Encloses(hull, inner));
  EXPECT_FALSE(Encloses(inner, hull));
  TriangleSoup apart = inner;
  apart.points.rowwise() += Eigen::RowVector3d(20, 0, 0);
  EXPECT_FALSE(Encloses(hull, apart));
  // One vertex sticks out.
  TriangleSoup spike = inner;
  spike.points.row(0) *= 3;
  EXPECT_FALSE(Encloses(hull, spike));
  // All vertices inside, but a spike of the hull pierces a face.
  TriangleSoup pierced = Icosphere(20, 2);
  pierced.points.row(0) *= 0.1;
  EXPECT_FALSE(Encloses(pierced, Box(12, 12, 12)));
  // Touching is not inside.
  EXPECT_FALSE(Encloses(hull, Box(10, 4, 4)));
}

TEST(Encloses, TouchingIsNotEnclosing) {
  const TriangleSoup fine = Box(1, 1, 1);
  EXPECT_FALSE(Encloses(fine, fine));
  EXPECT_FALSE(Encloses(MovedBy(Box(2, 2, 2), {0.5, 0, 0}), fine));
  EXPECT_TRUE(Encloses(MovedBy(Box(2, 2, 2), {0.5 - 1e-15, 0, 0}), fine));
}

TEST(Encloses, ADentOfTheHullIntoAFace) {
  // All corners of the fine mesh are inside; the dent's tip reaches in, or not.
  TriangleSoup hull = Box(4, 4, 4);
  const Eigen::Index tip = hull.points.rows();
  hull.points.conservativeResize(tip + 1, 3);
  const Eigen::RowVector3i face = hull.triangles.row(0);
  const RowVector3d center =
      (hull.points.row(face[0]) + hull.points.row(face[1]) +
       hull.points.row(face[2])) /
      3;
  hull.triangles.conservativeResize(hull.triangles.rows() + 2, 3);
  const int t = static_cast<int>(tip);
  hull.triangles.row(0) << face[0], face[1], t;
  hull.triangles.row(12) << face[1], face[2], t;
  hull.triangles.row(13) << face[2], face[0], t;
  const TriangleSoup fine = Box(2, 2, 2);
  hull.points.row(tip) = RowVector3d(center[0], center[1], -1.01);
  EXPECT_TRUE(Encloses(hull, fine));
  hull.points.row(tip) = RowVector3d(center[0], center[1], -0.99);
  EXPECT_FALSE(Encloses(hull, fine));
}

TEST(Encloses, APieceOutside) {
  EXPECT_FALSE(Encloses(
      Box(4, 4, 4), Together(Box(1, 1, 1), MovedBy(Box(1, 1, 1), {10, 0, 0}))));
}

TEST(Encloses, OpenOrInsideOutHulls) {
  const TriangleSoup fine = Icosphere(1, 1);
  TriangleSoup open = Box(4, 4, 4);
  open.triangles = open.triangles.bottomRows(11).eval();
  EXPECT_FALSE(Encloses(open, fine));
  TriangleSoup inverted = Box(4, 4, 4);
  inverted.triangles.col(0).swap(inverted.triangles.col(1));
  EXPECT_FALSE(Encloses(inverted, fine));
  EXPECT_FALSE(Encloses({Points(0, 3), Triangles(0, 3)}, fine));
}

}  // namespace musclewarp
