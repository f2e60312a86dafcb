// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/fibres/distance_outside.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "musclewarp/base/infinity.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

TEST(DistanceOutside, IsZeroInsideAndTheDistanceOutside) {
  const TriangleSoup box = Box(2, 4, 6);
  const TriangleBvh tree(box.points, box.triangles);
  EXPECT_EQ(DistanceOutside({&tree}, {0.9, 1.9, 2.9}), 0);
  EXPECT_DOUBLE_EQ(DistanceOutside({&tree}, {0, 0, 7}), 4);
  EXPECT_EQ(DistanceOutside({}, {0, 0, 0}), kInfinity);
}

// Beyond a sharp corner a triangle that touches it may show its back.
TEST(DistanceOutside, IsThatOfAPointBeyondASharpCorner) {
  TriangleSoup needle = UnitTetrahedron();
  needle.points.col(2) *= 50;
  const TriangleBvh tree(needle.points, needle.triangles);
  const Eigen::RowVector3d corner(0, 0, 50);
  const Points ways = RandomPoints(500, 1);
  for (const auto& way : ways.rowwise()) {
    // Of these points the corner is nearest: they are behind all its edges.
    if (way[2] < 0 || std::max(way[0], way[1]) > 50 * way[2]) continue;
    EXPECT_NEAR(DistanceOutside({&tree}, corner + way), way.norm(), 1e-12);
  }
}

TEST(DistanceOutside, IsThatOfTheNearestOfSeveralMeshes) {
  const TriangleSoup near = SphereAt({0, 0, 20}, 5, 2);
  const TriangleSoup far = SphereAt({0, 0, -60}, 5, 2);
  const TriangleBvh near_tree(near.points, near.triangles);
  const TriangleBvh far_tree(far.points, far.triangles);
  EXPECT_NEAR(DistanceOutside({&far_tree, &near_tree}, {0, 0, 0}), 15, 0.5);
  EXPECT_EQ(DistanceOutside({&far_tree, &near_tree}, {0, 0, -60}), 0);
}

}  // namespace
}  // namespace musclewarp
