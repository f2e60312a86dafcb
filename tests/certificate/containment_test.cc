// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certificate/containment.h"

#include <gtest/gtest.h>

#include <random>

#include "support/meshes.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

TEST(IsInsideClosed, KnowsABox) {
  // Corner, edge and face directions meet edges of the triangles.
  const TriangleSoup box = Box(20, 20, 20);
  const BoxedMesh view(SurfaceView{&box.points, &box.triangles});
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-15, 15);
  for (int i = 0; i < 500; ++i) {
    const RowVector3d p(uniform(random), uniform(random), uniform(random));
    EXPECT_EQ(IsInsideClosed(p, view), p.cwiseAbs().maxCoeff() < 10) << p;
  }
  EXPECT_TRUE(IsInsideClosed(RowVector3d::Zero(), view));
  EXPECT_TRUE(IsInsideClosed(RowVector3d(10 - 1e-12, 3, 0), view));
  EXPECT_FALSE(IsInsideClosed(RowVector3d(10 + 1e-12, 3, 0), view));
}

TEST(IsInsideClosed, WhatIsOnTheSurfaceIsNotInside) {
  const TriangleSoup box = Box(20, 20, 20);
  const BoxedMesh view(SurfaceView{&box.points, &box.triangles});
  for (const RowVector3d& p : {RowVector3d(10, 3, 4),
                               RowVector3d(10, 10, 10),
                               RowVector3d(-10, 10, 0),
                               RowVector3d(0, 0, 10)}) {
    EXPECT_FALSE(IsInsideClosed(p, view)) << p;
  }
}

TEST(IsInsideClosed, AHoleInsideIsOutside) {
  TriangleSoup hole = Icosphere(5, 2);
  hole.triangles.col(0).swap(hole.triangles.col(1));
  const TriangleSoup shell = Together(Icosphere(10, 3), hole);
  const BoxedMesh view(SurfaceView{&shell.points, &shell.triangles});
  EXPECT_FALSE(IsInsideClosed(RowVector3d(1, 0.5, 0), view));
  EXPECT_TRUE(IsInsideClosed(RowVector3d(7, 0.5, 0), view));
}

// Two vertebrae of one mesh may lie in each other.
TEST(IsInsideClosed, WhereTwoSurfacesOverlapIsInside) {
  const TriangleSoup both =
      Together(SphereAt({0, 0, 0}, 10, 3), SphereAt({12, 0, 0}, 10, 3));
  const BoxedMesh view(SurfaceView{&both.points, &both.triangles});
  EXPECT_TRUE(IsInsideClosed(RowVector3d(0, 0.5, 0), view));
  EXPECT_TRUE(IsInsideClosed(RowVector3d(6, 0.5, 0), view));
  EXPECT_TRUE(IsInsideClosed(RowVector3d(12, 0.5, 0), view));
  EXPECT_FALSE(IsInsideClosed(RowVector3d(6, 9, 0), view));
}

// The certificate errs on the side of more crossings. A triangle whose corners
// are one point, beside every ray, leaves each of them undecided.
TEST(IsInsideClosed, WhatNoRayDecidesCountsAsInside) {
  TriangleSoup sphere = Icosphere(10, 2);
  const RowVector3d outside(6, -9, 6);  // within the bounding box
  {
    const BoxedMesh view(SurfaceView{&sphere.points, &sphere.triangles});
    ASSERT_FALSE(IsInsideClosed(outside, view));
  }
  const Eigen::Index v = sphere.points.rows();
  sphere.points.conservativeResize(v + 1, 3);
  sphere.points.row(v) = outside + RowVector3d(1, 1e-3, -1e-4);
  sphere.triangles.conservativeResize(sphere.triangles.rows() + 1, 3);
  sphere.triangles.bottomRows<1>().setConstant(static_cast<int>(v));
  const BoxedMesh view(SurfaceView{&sphere.points, &sphere.triangles});
  EXPECT_TRUE(IsInsideClosed(outside, view));
}

}  // namespace
}  // namespace musclewarp
