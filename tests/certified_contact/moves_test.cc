// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/moves.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace musclewarp {
namespace {

using ::testing::ElementsAre;

// Points of which number k moves by k mm, from 0 to 99.
std::vector<Points> Graded() {
  Points points = Points::Zero(100, 3);
  for (int k = 0; k < 100; ++k) points(k, 1) = k;
  return {points};
}

TEST(MovesOfMost, LeaveOutTheShareThatMovesMost) {
  const std::vector<Points> at_rest = {Points::Zero(100, 3)};
  EXPECT_THAT(MovesOfMost(at_rest, Graded(), 0), ElementsAre(99));
  EXPECT_THAT(MovesOfMost(at_rest, Graded(), 0.01), ElementsAre(98));
  EXPECT_THAT(MovesOfMost(Graded(), at_rest, 0.1), ElementsAre(89));
  EXPECT_THAT(MovesOfMost(Graded(), Graded(), 0), ElementsAre(0));
  EXPECT_THAT(MovesOfMost({Points()}, {Points()}, 0.1), ElementsAre(0));
}

TEST(MoveOfMostMoved, IsOfTheMuscleThatMovesMost) {
  std::vector<Points> before = {Points::Zero(100, 3), Points::Zero(100, 3)};
  std::vector<Points> after = {Points::Zero(100, 3), Graded()[0]};
  EXPECT_THAT(MovesOfMost(before, after, 0.05), ElementsAre(0, 94));
  EXPECT_EQ(MoveOfMostMoved(before, after, 0.05), 94);
  EXPECT_EQ(MoveOfMostMoved({}, {}, 0.05), 0);
}

}  // namespace
}  // namespace musclewarp
