// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/outer_hull.h"

#include <gtest/gtest.h>

#include "musclewarp/mesh/defects.h"
#include "musclewarp/mesh/measures.h"
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

}  // namespace musclewarp
