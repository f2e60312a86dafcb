// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/spread_points.h"

#include <gtest/gtest.h>

#include <vector>

namespace musclewarp {
namespace {

// x = 0, 1, ..., count - 1.
Points OnALine(int count) {
  Points points = Points::Zero(count, 3);
  for (int i = 0; i < count; ++i) points(i, 0) = i;
  return points;
}

}  // namespace

TEST(SpreadPoints, TakesTheFarthestFromThoseTaken) {
  // The other end, then the middle, then the middles of the halves.
  EXPECT_EQ(SpreadPoints(OnALine(9), 5), (std::vector<int>{0, 8, 4, 2, 6}));
}

TEST(SpreadPoints, TakesAllOfFew) {
  EXPECT_EQ(SpreadPoints(OnALine(3), 10), (std::vector<int>{0, 2, 1}));
  EXPECT_TRUE(SpreadPoints(Points(0, 3), 10).empty());
}

TEST(SpreadPoints, TakesOnePointOfAPlace) {
  Points points(4, 3);
  points << OnALine(2), OnALine(2);
  EXPECT_EQ(SpreadPoints(points, 4), (std::vector<int>{0, 1}));
}

}  // namespace musclewarp
