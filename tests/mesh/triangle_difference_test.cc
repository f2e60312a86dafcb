// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh/triangle_difference.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/meshes.h"

namespace musclewarp {
namespace {

TEST(TrianglesNotIn, AMeshHasAllOfItsTrianglesWhateverTheirOrder) {
  const TriangleSoup sphere = Icosphere(10, 2);
  TriangleSoup turned = sphere;
  turned.points = sphere.points.colwise().reverse();
  turned.triangles =
      (static_cast<int>(sphere.points.rows()) - 1 - sphere.triangles.array())
          .rowwise()
          .reverse()
          .colwise()
          .reverse();
  EXPECT_EQ(TrianglesNotIn(sphere, turned).triangles.rows(), 0);
  EXPECT_EQ(TrianglesNotIn(sphere, turned).points.rows(), 0);
}

TEST(TrianglesNotIn, FindsAPieceThatWasLeftOut) {
  const TriangleSoup kept = SphereAt({0, 0, 0}, 10, 2);
  const TriangleSoup left_out = SphereAt({30, 0, 0}, 5, 1);
  const TriangleSoup found = TrianglesNotIn(Together(kept, left_out), kept);
  EXPECT_EQ(found.points, left_out.points);
  EXPECT_EQ(found.triangles, left_out.triangles);
}

TEST(TrianglesNotIn, FindsTheTrianglesAroundAPointThatMovedByOneBit) {
  const TriangleSoup sphere = Icosphere(10, 2);
  TriangleSoup moved = sphere;
  moved.points(0, 0) = std::nextafter(moved.points(0, 0), 100);
  // The corners of the icosahedron have five triangles.
  EXPECT_EQ(TrianglesNotIn(sphere, moved).triangles.rows(), 5);
}

TEST(TrianglesNotIn, ATriangleWithTwoCornersInOnePlaceAddsNothing) {
  TriangleSoup soup = Icosphere(10, 1);
  const TriangleSoup sphere = soup;
  soup.triangles.conservativeResize(soup.triangles.rows() + 1, 3);
  soup.triangles.bottomRows(1) << 0, 1, 1;
  EXPECT_EQ(TrianglesNotIn(soup, sphere).triangles.rows(), 0);
}

}  // namespace
}  // namespace musclewarp
