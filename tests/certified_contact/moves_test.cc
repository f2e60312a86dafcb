// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/moves.h"

#include <gtest/gtest.h>

namespace musclewarp {
namespace {

// Points of which number k moves by k mm, from 0 to 99.
std::vector<Points> Graded() {
  Points points = Points::Zero(100, 3);
  for (int k = 0; k < 100; ++k) points(k, 1) = k;
  return {points};
}

TEST(MoveOfMost, LeavesOutTheShareThatMovesMost) {
  const std::vector<Points> at_rest = {Points::Zero(100, 3)};
  EXPECT_EQ(MoveOfMost(at_rest, Graded(), 0), 99);
  EXPECT_EQ(MoveOfMost(at_rest, Graded(), 0.01), 98);
  EXPECT_EQ(MoveOfMost(Graded(), at_rest, 0.1), 89);
  EXPECT_EQ(MoveOfMost(Graded(), Graded(), 0), 0);
  EXPECT_EQ(MoveOfMost({}, {}, 0.1), 0);
}

TEST(MoveOfMost, TakesAllMusclesTogetherOrTheOneThatMovesMost) {
  std::vector<Points> before = {Points::Zero(100, 3), Points::Zero(100, 3)};
  std::vector<Points> after = {Points::Zero(100, 3), Graded()[0]};
  // Of two hundred points the ten that move most are left out.
  EXPECT_EQ(MoveOfMost(before, after, 0.05), 89);
  EXPECT_EQ(MoveOfMostMoved(before, after, 0.05), 94);
}

}  // namespace
}  // namespace musclewarp
