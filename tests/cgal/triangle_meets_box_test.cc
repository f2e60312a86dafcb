// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/cgal/triangle_meets_box.h"

#include <gtest/gtest.h>

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

const RowVector3d kLower(0, 0, 0), kUpper(1, 1, 1);

bool MeetsUnitBox(const RowVector3d& a,
                  const RowVector3d& b,
                  const RowVector3d& c) {
  Corners corners;
  corners << a, b, c;
  return TriangleMeetsBox(corners, kLower, kUpper);
}

}  // namespace

TEST(TriangleMeetsBox, ACornerInsideAnEdgeThroughAndAFaceAcross) {
  EXPECT_TRUE(MeetsUnitBox({.5, .5, .5}, {5, 5, 5}, {5, 6, 5}));
  EXPECT_TRUE(MeetsUnitBox({-1, .5, .5}, {2, .5, .5}, {.5, 9, 9}));
  EXPECT_TRUE(MeetsUnitBox({-9, -9, .5}, {9, -9, .5}, {0, 9, .5}));
}

TEST(TriangleMeetsBox, ItsBorderBelongsToTheBox) {
  EXPECT_TRUE(MeetsUnitBox({1, .5, .5}, {2, .5, .5}, {2, .6, .5}));
  EXPECT_FALSE(MeetsUnitBox({1 + 1e-9, .5, .5}, {2, .5, .5}, {2, .6, .5}));
}

TEST(TriangleMeetsBox, OverlappingBoundsAreNotEnough) {
  // Beyond the corner (1, 1, 1), though the bounds overlap.
  EXPECT_FALSE(MeetsUnitBox({3.1, 0, 0}, {0, 3.1, 0}, {0, 0, 3.1}));
  EXPECT_TRUE(MeetsUnitBox({2.9, 0, 0}, {0, 2.9, 0}, {0, 0, 2.9}));
}

}  // namespace musclewarp
