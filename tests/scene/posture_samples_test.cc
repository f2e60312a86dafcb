// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/posture_samples.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>
#include <vector>

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(LatinHypercube, HasOneSampleInEachIntervalOfEachCoordinate) {
  for (const int count : {1, 2, 7, 200}) {
    const Eigen::MatrixXd samples = LatinHypercube(count, 4, 3);
    ASSERT_EQ(samples.rows(), count);
    ASSERT_EQ(samples.cols(), 4);
    for (int k = 0; k < 4; ++k) {
      std::set<int> intervals;
      for (int i = 0; i < count; ++i) {
        EXPECT_GE(samples(i, k), 0);
        EXPECT_LT(samples(i, k), 1);
        intervals.insert(static_cast<int>(std::floor(samples(i, k) * count)));
      }
      EXPECT_EQ(intervals.size(), static_cast<size_t>(count));
    }
  }
}

TEST(LatinHypercube, IsThatOfItsSeed) {
  EXPECT_EQ(LatinHypercube(50, 3, 1), LatinHypercube(50, 3, 1));
  EXPECT_NE(LatinHypercube(50, 3, 1), LatinHypercube(50, 3, 2));
}

TEST(GridSamples, HaveTheEndsAndEqualSpacings) {
  const Eigen::MatrixXd samples = GridSamples({3, 1, 2});
  Eigen::MatrixXd expected(6, 3);
  expected << 0, 0.5, 0,  //
      0, 0.5, 1,          //
      0.5, 0.5, 0,        //
      0.5, 0.5, 1,        //
      1, 0.5, 0,          //
      1, 0.5, 1;
  EXPECT_EQ(samples, expected);
}

TEST(GridCounts, FollowTheWidthsOfTheRanges) {
  EXPECT_THAT(GridCounts({90, 70, 60}, 200), ElementsAre(8, 5, 5));
  EXPECT_THAT(GridCounts({10, 10}, 9), ElementsAre(3, 3));
  EXPECT_THAT(GridCounts({10, 10}, 4), ElementsAre(2, 2));
  EXPECT_THAT(GridCounts({10}, 20000), ElementsAre(20000));
}

TEST(GridCounts, NeverExceedTheNumberOfPostures) {
  for (const int most : {8, 9, 30, 64, 1000}) {
    const std::vector<int> counts = GridCounts({90, 70, 60}, most);
    const int product = std::accumulate(
        counts.begin(), counts.end(), 1, [](int a, int b) { return a * b; });
    EXPECT_LE(product, most);
    // No coordinate has room for one more.
    for (const int count : counts) {
      EXPECT_GT(product / count * (count + 1), most);
    }
  }
}

TEST(GridCounts, NeedTwoPointsOfEachCoordinate) {
  EXPECT_THAT(GridCounts({1, 1, 1}, 7), IsEmpty());
  // The product of 40 coordinates is beyond 64 bits.
  EXPECT_THAT(GridCounts(std::vector<double>(70, 1.0), 20000), IsEmpty());
}

}  // namespace
}  // namespace musclewarp
