// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/sharp_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "musclewarp/base/angles.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

int NumSharp(const TriangleSoup& soup) {
  const std::vector<bool> is_sharp = SharpPoints(soup);
  return static_cast<int>(std::count(is_sharp.begin(), is_sharp.end(), true));
}

// A roof over a square of 2 mm, whose sides rise by so many degrees: the angle
// inside along its lower edges.
TriangleSoup Roof(double degrees) {
  const double h = std::tan(RadiansOf(degrees));
  TriangleSoup roof;
  roof.points =
      Points{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, h}};
  roof.triangles = Triangles{
      {0, 2, 1}, {0, 3, 2}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  return roof;
}

TEST(SharpPoints, ABallHasNone) { EXPECT_EQ(NumSharp(Icosphere(10, 2)), 0); }

TEST(SharpPoints, EdgesAreSharpBelowTheirLimit) {
  EXPECT_EQ(NumSharp(Roof(kSharpEdgeDeg + 0.1)), 0);
  EXPECT_EQ(NumSharp(Roof(kSharpEdgeDeg - 0.1)), 5);
}

// Seen from the other side the same edges are reflex, 345 degrees.
TEST(SharpPoints, ReflexEdgesAreNotSharp) {
  TriangleSoup roof = Roof(kSharpEdgeDeg - 0.1);
  roof.triangles.col(0).swap(roof.triangles.col(1));
  EXPECT_EQ(NumSharp(roof), 0);
}

TEST(SharpPoints, TrianglesAreSharpBelowTheirLimit) {
  TriangleSoup needle = UnitTetrahedron();
  EXPECT_EQ(NumSharp(needle), 0);
  needle.points.col(0) *= 0.99 * std::tan(RadiansOf(kSharpTriangleDeg));
  EXPECT_EQ(NumSharp(needle), 4);
}

}  // namespace
}  // namespace musclewarp
