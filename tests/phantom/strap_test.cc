// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/phantom/strap.h"

#include <gtest/gtest.h>

#include <vector>

namespace musclewarp::phantom {
namespace {

using Eigen::Vector3d;

// Distances are square roots of exact sums.
constexpr double kDistanceRounding = 1e-12;  // mm

// Along x, 100 mm long, 6 mm thick, and as wide along y as is asked.
std::vector<StrapNode> StraightNodes(double half_width) {
  std::vector<StrapNode> nodes;
  for (const double x : {0., 25., 50., 75., 100.}) {
    nodes.push_back({{x, 0, 0}, Vector3d::UnitY(), half_width, 3});
  }
  return nodes;
}

TEST(Strap, WithoutWidthIsASweep) {
  const Field strap = Strap(StraightNodes(0));
  const Field sweep =
      Sweep({{{0, 0, 0}, 3}, {{50, 0, 0}, 3}, {{100, 0, 0}, 3}});
  for (const Vector3d& p : {Vector3d(20, 0, 0),
                            Vector3d(31, 4, -3),
                            Vector3d(-8, 1, 2),
                            Vector3d(110, 0, 5)}) {
    EXPECT_NEAR(strap(p), sweep(p), kDistanceRounding) << p.transpose();
  }
}

TEST(Strap, IsThickInTheMiddleAndThinAtTheEdges) {
  const Field strap = Strap(StraightNodes(20));
  EXPECT_NEAR(strap({40, 0, 0}), -3, kDistanceRounding);
  EXPECT_NEAR(strap({40, 0, 3}), 0, kDistanceRounding);
  EXPECT_NEAR(strap({40, 0, -5}), 2, kDistanceRounding);
  // 0.6 of the thickness at the edge, which is round.
  EXPECT_NEAR(strap({40, 20, 1.8}), 0, kDistanceRounding);
  EXPECT_NEAR(strap({40, -21.8, 0}), 0, kDistanceRounding);
  EXPECT_NEAR(strap({103, 0, 0}), 0, kDistanceRounding);
}

TEST(Strap, FarAwayTheDistanceIsALowerBound) {
  const Field strap = Strap(StraightNodes(20));
  const double distance = strap({50, 300, 400});
  EXPECT_GT(distance, 30);
  EXPECT_LE(distance, Vector3d(0, 280, 400).norm());
}

TEST(Strap, ItsBoxHoldsItWithTheMargin) {
  std::vector<StrapNode> nodes = StraightNodes(20);
  nodes[2].centre.z() = 30;
  const Field strap = Strap(nodes);
  constexpr double kMargin = 4;  // mm
  const Eigen::AlignedBox3d box = StrapBox(nodes, kMargin);
  for (double y = box.min().y(); y <= box.max().y(); y += 2) {
    for (double x = box.min().x(); x <= box.max().x(); x += 2) {
      EXPECT_GE(strap({x, y, box.min().z()}), kMargin - kDistanceRounding);
      EXPECT_GE(strap({x, y, box.max().z()}), kMargin - kDistanceRounding);
    }
  }
  EXPECT_EQ(box.min().x(), -3 - kMargin);
  EXPECT_EQ(box.max().y(), 20 + 3 + kMargin);
}

TEST(StrapDeathTest, NeedsTwoNodes) {
  EXPECT_DEATH(Strap({StraightNodes(0)[0]}), "Check failed");
}

}  // namespace
}  // namespace musclewarp::phantom
