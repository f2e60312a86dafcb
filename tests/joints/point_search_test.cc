// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/point_search.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "support/meshes.h"

namespace musclewarp {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(PointSearch, FindsWhatBruteForceFinds) {
  const Points points = RandomPoints(800, 1);
  const PointSearch search(points);
  int found = 0;
  // Places within the cloud and far outside of it.
  const Points places = 1.5 * RandomPoints(300, 2);
  for (const auto& place : places.rowwise()) {
    for (const double radius : {0.05, 0.4, 1.0}) {
      std::vector<int> expected;
      for (int i = 0; i < points.rows(); ++i) {
        if ((points.row(i) - place).norm() <= radius) expected.push_back(i);
      }
      found += static_cast<int>(expected.size());
      EXPECT_EQ(search.Within(place, radius), expected);
    }
    int nearest = 0;
    (points.rowwise() - place).rowwise().squaredNorm().minCoeff(&nearest);
    EXPECT_EQ(search.Nearest(place), nearest);
  }
  ASSERT_GT(found, 10000);
}

TEST(PointSearch, CountsPointsAtTheRadiusItself) {
  Points points(125, 3);
  const auto index = [](int x, int y, int z) { return x + 5 * y + 25 * z; };
  for (int x = 0; x < 5; ++x) {
    for (int y = 0; y < 5; ++y) {
      for (int z = 0; z < 5; ++z) points.row(index(x, y, z)) << x, y, z;
    }
  }
  const PointSearch search(points);
  EXPECT_THAT(search.Within({2, 2, 2}, 1),
              ElementsAre(index(2, 2, 1),
                          index(2, 1, 2),
                          index(1, 2, 2),
                          index(2, 2, 2),
                          index(3, 2, 2),
                          index(2, 3, 2),
                          index(2, 2, 3)));
  EXPECT_THAT(search.Within({2, 2, 2}, 0.999), ElementsAre(index(2, 2, 2)));
  EXPECT_THAT(search.Within({2, 2, 2}, 0), ElementsAre(index(2, 2, 2)));
  // From outside of the box of the points, where whole parts of the tree are
  // left out.
  EXPECT_THAT(search.Within({-3, 2, 2}, 3), ElementsAre(index(0, 2, 2)));
  EXPECT_THAT(search.Within({-3, 2, 2}, 2.999), IsEmpty());
  EXPECT_EQ(search.Within({2, 2, 2}, 4).size(), 125u);
}

TEST(PointSearch, FindsEachOfSeveralPointsInOnePlace) {
  const Points points = Points::Constant(100, 3, 7);
  const PointSearch search(points);
  EXPECT_EQ(search.Within({7, 7, 7}, 0).size(), 100u);
  EXPECT_GE(search.Nearest({0, 0, 0}), 0);
}

TEST(PointSearch, FindsNothingWithoutPoints) {
  const Points none(0, 3);
  const PointSearch search(none);
  EXPECT_THAT(search.Within({0, 0, 0}, 1e6), IsEmpty());
  EXPECT_EQ(search.Nearest({0, 0, 0}), -1);
}

TEST(PointSearch, FindsTheSameAfterItIsMoved) {
  const Points points = RandomPoints(50, 3);
  PointSearch first(points);
  const std::vector<int> within = first.Within({0, 0, 0}, 0.8);
  ASSERT_FALSE(within.empty());
  const PointSearch second = std::move(first);
  EXPECT_EQ(second.Within({0, 0, 0}, 0.8), within);
}

}  // namespace
}  // namespace musclewarp
