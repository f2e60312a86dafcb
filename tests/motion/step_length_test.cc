// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/step_length.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "musclewarp/base/infinity.h"

namespace musclewarp {
namespace {

StepLengthOptions Options() {
  StepLengthOptions options;
  options.longest = 0.4;
  options.max_push = 2;
  options.unchecked = 0.05;
  options.shortest = 0.0125;
  return options;
}

TEST(StepLength, DividesTheWayEvenly) {
  StepLength length(Options());
  EXPECT_DOUBLE_EQ(length.NextFrom(0), 1.0 / 3);
  EXPECT_DOUBLE_EQ(length.NextFrom(1.0 / 3), 2.0 / 3);
  // The last one ends at the goal, not beside it.
  EXPECT_EQ(length.NextFrom(2.0 / 3), 1);
}

TEST(StepLength, LeavesNoTinyStepForTheEnd) {
  StepLengthOptions options;
  options.longest = 0.499;
  EXPECT_EQ(StepLength(options).NextFrom(0), 0.5);
}

TEST(StepLength, IsShortenedByAsMuchAsThePushIsTooLarge) {
  StepLength length(Options());
  EXPECT_FALSE(length.ShortenFor(2));
  EXPECT_EQ(length.length(), 0.4);
  EXPECT_TRUE(length.ShortenFor(4));
  // Proportional, and some more to be sure of the next step.
  EXPECT_LT(length.length(), 0.2);
  EXPECT_GT(length.length(), 0.1);
  // At least by half.
  EXPECT_TRUE(length.ShortenFor(2.001));
  EXPECT_LE(length.length(), 0.1);
}

TEST(StepLength, IsNotShortenedForThePushBelowTheUncheckedLength) {
  StepLength length(Options());
  EXPECT_TRUE(length.ShortenFor(1000));
  EXPECT_DOUBLE_EQ(length.length(), 0.05);
  EXPECT_EQ(length.max_push(), kInfinity);
  EXPECT_FALSE(length.ShortenFor(1000));
  EXPECT_DOUBLE_EQ(length.length(), 0.05);
}

TEST(StepLength, IsHalvedDownToTheShortest) {
  StepLength length(Options());
  int halvings = 0;
  while (length.Halve()) ++halvings;
  EXPECT_EQ(halvings, 5);
  EXPECT_DOUBLE_EQ(length.length(), 0.0125);
}

TEST(StepLength, GrowsAsThePushAllows) {
  StepLengthOptions options = Options();
  StepLength length(options);
  length.ShortenFor(8);
  const double before = length.length();
  // Not after a step that had to be shortened.
  length.Grow(0);
  EXPECT_DOUBLE_EQ(length.length(), before);
  // Not while the push is near the limit.
  length.Grow(1.9);
  EXPECT_DOUBLE_EQ(length.length(), before);
  // Twice at most, up to the longest.
  length.Grow(0);
  EXPECT_DOUBLE_EQ(length.length(), 2 * before);
  for (int i = 0; i < 9; ++i) length.Grow(0);
  EXPECT_EQ(length.length(), options.longest);
}

// A push that is proportional to the length stays within the limit, with few
// steps that are given up.
TEST(StepLength, FollowsAPushThatChangesOnTheWay) {
  StepLength length(Options());
  double at = 0;
  int steps = 0, given_up = 0;
  while (at < 1) {
    const double to = length.NextFrom(at);
    // From 5 to 25 mm for the whole way.
    const double push = (to - at) * (5 + 20 * at);
    if (length.ShortenFor(push)) {
      ++given_up;
      continue;
    }
    EXPECT_LE(push, 2);
    length.Grow(push);
    at = to;
    ++steps;
  }
  EXPECT_EQ(at, 1);
  EXPECT_LE(given_up, 2);
  // 15 mm in pushes of 1 to 2 mm.
  EXPECT_LE(steps, 15);
}

}  // namespace
}  // namespace musclewarp
