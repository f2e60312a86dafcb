// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/paper_contact/regions.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace musclewarp {
namespace {

using Pairs = std::vector<std::pair<int, int>>;

Region At(double x, double y) { return {{0}, {x, y, 0}}; }

}  // namespace

TEST(ConnectedRegions, HangTogetherByEdges) {
  const TriangleSoup box = LatticeBox(6, 4, 2);
  // Two patches of the upper side, two units apart.
  std::vector<int> inside;
  for (int v = 0; v < box.points.rows(); ++v) {
    const Eigen::RowVector3d p = box.points.row(v);
    if (p.z() == 2 && (p.x() <= 1 || p.x() >= 5)) inside.push_back(v);
  }
  const auto regions = ConnectedRegions(inside, box.points, box.triangles);
  ASSERT_EQ(regions.size(), 2u);
  for (const Region& region : regions) {
    EXPECT_EQ(region.vertices.size(), 10u);
    EXPECT_DOUBLE_EQ(region.centre.y(), 2);
    EXPECT_DOUBLE_EQ(region.centre.z(), 2);
    EXPECT_TRUE(region.centre.x() == 0.5 || region.centre.x() == 5.5);
  }
}

TEST(ConnectedRegions, VerticesWithoutAnEdgeBetweenThemStayApart) {
  // Both ends of a diagonal that is not there.
  Triangles triangles(2, 3);
  triangles << 0, 1, 2, 0, 2, 3;
  Points points(4, 3);
  points << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0;
  EXPECT_EQ(ConnectedRegions({1, 3}, points, triangles).size(), 2u);
  EXPECT_EQ(ConnectedRegions({0, 2}, points, triangles).size(), 1u);
  EXPECT_TRUE(ConnectedRegions({}, points, triangles).empty());
}

TEST(PairRegions, TheClosestGoFirst) {
  // b0 is nearest to a1, which a0 would take if it came first.
  EXPECT_EQ(PairRegions({At(0, 0), At(2, 0)}, {At(1.5, 0), At(-2, 0)}, 10),
            (Pairs{{1, 0}, {0, 1}}));
}

TEST(PairRegions, NotBeyondTheDistance) {
  EXPECT_EQ(PairRegions({At(0, 0), At(9, 0)}, {At(1, 0), At(9, 2)}, 1),
            (Pairs{{0, 0}}));
  EXPECT_TRUE(PairRegions({At(0, 0)}, {}, 1).empty());
}

TEST(PairRegions, EachOnceAndTiesByIndex) {
  EXPECT_EQ(PairRegions({At(0, 0)}, {At(0, 1), At(0, -1)}, 2), (Pairs{{0, 0}}));
  EXPECT_EQ(PairRegions({At(0, 1), At(0, -1)}, {At(0, 0)}, 2), (Pairs{{0, 0}}));
}

}  // namespace musclewarp
