// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/proximity/self_crossing_search.h"

#include <gtest/gtest.h>

#include "musclewarp/proximity/mesh_intersection.h"
#include "proximity/crumpled_sphere.h"

namespace musclewarp {
namespace {

// Whatever the groups are made of.
TEST(SelfCrossingSearch, FindsTheSameAsTheTree) {
  for (const double by : {0.0, 0.5, 1.5, 4.0}) {
    const TriangleSoup sphere = CrumpledSphere(by, 5);
    const auto expected =
        SelfIntersections(TriangleBvh(sphere.points, sphere.triangles));
    EXPECT_EQ(expected.empty(), by < 1) << by;
    for (const Points& rest :
         {sphere.points, Points(Points::Zero(sphere.points.rows(), 3))}) {
      EXPECT_EQ(SelfCrossingSearch(rest, sphere.triangles).Find(sphere.points),
                expected)
          << by;
    }
  }
}

TEST(SelfCrossingSearch, FindsCrossingsOfSmallAndOpenMeshes) {
  const TriangleSoup none = {Points(0, 3), Triangles(0, 3)};
  EXPECT_TRUE(SelfCrossingSearch(none.points, none.triangles)
                  .Find(none.points)
                  .empty());
  TriangleSoup two;  // and one that is folded onto the second
  two.points.resize(7, 3);
  two.points << 0, 0, 0, 2, 0, 0, 0, 2, 0, 0.5, 0.5, -1, 0.5, 0.5, 1, 3, 3, 0,
      0.4, 0.6, 0.5;
  two.triangles.resize(3, 3);
  two.triangles << 0, 1, 2, 3, 4, 5, 3, 4, 6;
  const auto expected =
      SelfIntersections(TriangleBvh(two.points, two.triangles));
  EXPECT_FALSE(expected.empty());
  EXPECT_EQ(SelfCrossingSearch(two.points, two.triangles).Find(two.points),
            expected);
}

}  // namespace
}  // namespace musclewarp
