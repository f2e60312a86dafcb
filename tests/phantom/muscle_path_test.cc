// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/phantom/muscle_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "musclewarp/skeleton/polyline.h"

namespace musclewarp::phantom {
namespace {

using Eigen::Vector3d;

constexpr double kPathRounding = 1e-12;  // of sums of a few coordinates, mm
constexpr double kBallRadius = 15;

PathObstacle BallObstacle(double depth) {
  return {Sphere(Vector3d::Zero(), kBallRadius),
          {Vector3d::Constant(-kBallRadius), Vector3d::Constant(kBallRadius)},
          depth};
}

// From (-40, 0, z) to (40, 0, z) in an arc that rises by `rise` mm.
std::vector<StrapNode> Arc(double z, double rise, double half_width) {
  std::vector<StrapNode> nodes;
  for (int i = 0; i <= 10; ++i) {
    const double t = i / 10.0;
    nodes.push_back({{-40 + 80 * t, 0, z + 4 * rise * t * (1 - t)},
                     Vector3d::UnitY(),
                     half_width,
                     3});
  }
  return nodes;
}

TEST(MusclePath, TheNormalOfABallPointsAwayFromItsCentre) {
  const Vector3d p(6, -8, 24);
  // Central differences at 0.05 mm of a distance of 26 mm.
  EXPECT_LT((NormalOf(BallObstacle(0).field, p) - p.normalized()).norm(), 1e-5);
}

TEST(MusclePath, WithoutObstaclesAPathBecomesStraight) {
  const std::vector<StrapNode> path =
      TautPath(Arc(0, 20, 0), {}, HalfSpace(Vector3d::UnitZ(), -5));
  // 112 rounds shrink the longest wave by 1 - 0.9 (1 - cos(pi / 10)) each.
  const double left = 20 * std::pow(1 - 0.9 * (1 - std::cos(M_PI / 10)), 112);
  for (const StrapNode& node : path) {
    EXPECT_LT(std::abs(node.centre.z()), 2 * left);
  }
}

TEST(MusclePath, APathLiesOnWhatIsInItsWay) {
  for (const double depth : {0., 2.}) {
    const PathObstacle ball = BallObstacle(depth);
    const std::vector<StrapNode> start = Arc(5, 25, 0);
    const std::vector<StrapNode> path = TautPath(start, {ball}, ball.field);
    EXPECT_EQ(path.front().centre, start.front().centre);
    EXPECT_EQ(path.back().centre, start.back().centre);
    double largest = -kBallRadius;
    for (const StrapNode& node : path) {
      largest = std::max(largest, Excess(node, ball));
    }
    // It touches the ball and is no deeper in it than it may be; the pushes
    // along differences of 0.05 mm leave an error of their square.
    EXPECT_NEAR(largest, 0, 1e-3);
    EXPECT_LT(PolylineLength(CentresOf(path)),
              PolylineLength(CentresOf(start)));
    EXPECT_GT(PolylineLength(CentresOf(path)), 80);
  }
}

TEST(MusclePath, AFlatStrapTurnsItsFlatSideToTheGround) {
  const Field ground = HalfSpace(Vector3d::UnitZ(), 0);
  std::vector<StrapNode> nodes = Arc(4, 0, 10);
  for (StrapNode& node : nodes) {
    node.across = Vector3d(0, 1, 1).normalized();
  }
  for (const StrapNode& node : TautPath(nodes, {}, ground)) {
    EXPECT_NEAR(std::abs(node.across.y()), 1, kPathRounding);
  }
}

TEST(MusclePath, ExcessCountsTheEdgesOfAFlatStrap) {
  const PathObstacle floor = {
      HalfSpace({1, 0, 0}, 0),
      {Vector3d(-100, -100, -100), Vector3d(0, 100, 100)},
      1};
  StrapNode node = {{10, 0, 0}, Vector3d::UnitX(), 0, 3};
  EXPECT_LT(Excess(node, floor), 0);
  // 0.8 of the half width reaches x = 2, where the strap is 0.744 as thick.
  node.half_width = 10;
  EXPECT_NEAR(Excess(node, floor), 0.744 * 3 - 1 - 2, kPathRounding);
}

}  // namespace
}  // namespace musclewarp::phantom
