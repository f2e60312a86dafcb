// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/random_draws.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace musclewarp {
namespace {

// Sums of rounded squares of unit vectors.
constexpr double kUnitRounding = 1e-14;

TEST(RandomDraws, AreThoseOfTheEngineThatTheStandardSpecifies) {
  // The standard gives the 10000th number of a default std::mt19937, whose seed
  // is 5489.
  RandomDraws draws(5489);
  for (int i = 1; i < 10000; ++i) draws.Uniform(0, 1);
  EXPECT_EQ(draws.Uniform(0, 4294967296.0), 4123659995.0);
}

TEST(RandomDraws, UniformNumbersFillTheirRange) {
  RandomDraws draws(1);
  double least = 7, largest = -3;
  for (int i = 0; i < 1000; ++i) {
    const double value = draws.Uniform(-3, 7);
    EXPECT_GE(value, -3);
    EXPECT_LT(value, 7);
    least = std::min(least, value);
    largest = std::max(largest, value);
  }
  EXPECT_LT(least, -2.9);
  EXPECT_GT(largest, 6.9);
}

TEST(RandomDraws, IntegersReachBothEndsAndNothingElse) {
  RandomDraws draws(2);
  std::set<int> seen;
  for (int i = 0; i < 200; ++i) seen.insert(draws.Integer(-1, 2));
  EXPECT_EQ(seen, (std::set<int>{-1, 0, 1, 2}));
  EXPECT_EQ(draws.Integer(5, 5), 5);
}

TEST(RandomDraws, ChancesAreTakenAtTheirRate) {
  RandomDraws draws(3);
  int taken = 0;
  for (int i = 0; i < 2000; ++i) taken += draws.Chance(0.25);
  // Five standard deviations of 19.4 each.
  EXPECT_NEAR(taken, 500, 97);
  EXPECT_FALSE(draws.Chance(0));
  EXPECT_TRUE(draws.Chance(1));
}

TEST(RandomDraws, DirectionsHaveUnitLengthAndNoPreference) {
  RandomDraws draws(4);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3d direction = draws.Direction();
    EXPECT_NEAR(direction.norm(), 1, kUnitRounding);
    const Eigen::Vector3d across = draws.DirectionAcross(direction);
    EXPECT_NEAR(across.norm(), 1, kUnitRounding);
    // The part along the direction is removed from a vector no shorter than a
    // tenth of what is left.
    EXPECT_NEAR(across.dot(direction), 0, 10 * kUnitRounding);
    sum += direction;
  }
  // Five standard deviations of each coordinate, sqrt(2000 / 3) = 25.8.
  EXPECT_LT(sum.cwiseAbs().maxCoeff(), 129);
}

TEST(RandomDrawsDeathTest, AnEmptyRangeOfIntegersIsRefused) {
  RandomDraws draws(1);
  EXPECT_DEATH(draws.Integer(2, 1), "Check failed");
}

}  // namespace
}  // namespace musclewarp
