// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/initial_separation/growth_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

namespace musclewarp {
namespace {

// A search, and what it tried.
struct Search {
  std::vector<double> tried;
  double found = 0;

  Search(const std::function<double(double)>& volume_at,
         double volume,
         double reach,
         double first) {
    const auto noted = [&](double t) {
      tried.push_back(t);
      return volume_at(t);
    };
    found = SearchGrowth(noted, volume_at(0), volume, reach, {first}).t;
    EXPECT_EQ(found, tried.back());
  }
  int steps() const { return static_cast<int>(tried.size()); }
};

// Of a square that grows on all sides, a cube, and a body that is hemmed in.
double Square(double t) { return 100 * (10 + t) * (10 + t); }
double Cube(double t) { return (10 + t) * (10 + t) * (10 + t); }
double HemmedIn(double t) { return 1000 - 900 * std::exp(-t / 4); }

constexpr double kAccuracy = 2e-3;  // of the volume, as it says

TEST(SearchGrowth, FindsTheVolumeOfBodiesThatGrowInAnyWay) {
  for (const auto& volume_at : {Square, Cube, HemmedIn}) {
    for (const double t : {0.3, 2.0, 7.7, 15.0}) {
      const double volume = volume_at(t);
      const Search search(volume_at, volume, 30, 1);
      EXPECT_LT(std::abs(volume_at(search.found) - volume), kAccuracy * volume);
      EXPECT_LE(search.steps(), 14);
    }
  }
}

// A volume that is off by a little more is not good enough, one that is off by
// a little less is: a step is 1 mm3 of 10000.
TEST(SearchGrowth, StopsWithinTwoInAThousand) {
  const auto line = [](double t) { return 1e4 * t; };
  EXPECT_EQ(Search(line, 1e4, 30, 1 + 0.0019).steps(), 1);
  EXPECT_EQ(Search(line, 1e4, 30, 1 - 0.0019).steps(), 1);
  EXPECT_GT(Search(line, 1e4, 30, 1 + 0.0021).steps(), 1);
  EXPECT_GT(Search(line, 1e4, 30, 1 - 0.0021).steps(), 1);
}

TEST(SearchGrowth, GoesHalfAsFarAgainUntilItIsTooFar) {
  const Search search(Square, Square(3), 30, 1);
  ASSERT_GE(search.steps(), 5);
  EXPECT_EQ(std::vector<double>(search.tried.begin(), search.tried.begin() + 4),
            (std::vector<double>{1, 1.5, 2.25, 3.375}));
  // By the chord between 2.25 and 3.375: Square(3) is 16900.
  const double part =
      (Square(3) - Square(2.25)) / (Square(3.375) - Square(2.25));
  EXPECT_NEAR(search.tried[4], 2.25 + part * 1.125, 1e-12);
}

// Fourteen steps of a half each are a factor of 195.
TEST(SearchGrowth, FindsAGrowthThatIsFarOff) {
  const auto line = [](double t) { return 1 + t; };
  const Search found(line, line(9.9), 30, 0.1);
  EXPECT_NEAR(line(found.found), line(9.9), kAccuracy * line(9.9));
  EXPECT_EQ(found.steps(), 14);
  EXPECT_EQ(Search(line, line(29), 30, 0.01).steps(), 14);
}

TEST(SearchGrowth, EndsAtItsReachIfThatIsNotEnough) {
  const Search search(Square, Square(8), 5, 1);
  EXPECT_EQ(search.found, 5);
  EXPECT_EQ(search.steps(), 5);  // 1, 1.5, 2.25, 3.375, 5
}

// The slope that coarser samples gave is good enough for the first step, on
// either side of the volume, and a wrong one does no harm.
TEST(SearchGrowth, GoesByTheSlopeIfItIsKnown) {
  for (const double first : {2.8, 3.2}) {
    std::vector<double> tried;
    const auto noted = [&](double t) {
      tried.push_back(t);
      return Square(t);
    };
    const GrowthGuess found =
        SearchGrowth(noted, Square(0), Square(3), 30, {first, 2600});
    EXPECT_EQ(tried.size(), 2) << first;
    EXPECT_EQ(found.t, tried.back());
    EXPECT_NEAR(found.slope,
                (Square(tried[1]) - Square(first)) / (tried[1] - first),
                1e-9);
    EXPECT_NEAR(Square(found.t), Square(3), kAccuracy * Square(3));
  }
  for (const double slope : {1.0, 1e6}) {
    const GrowthGuess found =
        SearchGrowth(Square, Square(0), Square(3), 30, {4, slope});
    EXPECT_NEAR(Square(found.t), Square(3), kAccuracy * Square(3)) << slope;
  }
}

// The place of a jump is found by tenths at least, whichever end is nearer to
// the volume.
TEST(SearchGrowth, NarrowsByATenthAtLeast) {
  const auto jump = [](double t) { return t < 1.2 ? 1 : 1e6; };
  const Search high(jump, 0.99e6, 30, 1), low(jump, 1e3, 30, 1);
  EXPECT_EQ(high.tried[2], 1 + 0.9 * 0.5);
  EXPECT_EQ(low.tried[2], 1 + 0.1 * 0.5);
  EXPECT_EQ(high.steps(), 14);
  EXPECT_NEAR(high.found, 1.2, 0.1);
}

}  // namespace
}  // namespace musclewarp
