// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/settling_progress.h"

#include <gtest/gtest.h>

#include <vector>

namespace musclewarp {
namespace {

// Adds moves, mm, until settling stalls. Returns their number, or 0.
int StepsUntilStalled(double reach, const std::vector<double>& moves) {
  SettlingProgress progress(reach);
  for (size_t i = 0; i < moves.size(); ++i) {
    progress.Add(moves[i]);
    if (progress.IsStalled()) return static_cast<int>(i) + 1;
  }
  return 0;
}

TEST(SettlingProgress, GoesOnWhileMovesShrink) {
  EXPECT_EQ(StepsUntilStalled(1, {0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2, 0.1}), 0);
  // Every third one is less than 0.9 of the least before.
  EXPECT_EQ(StepsUntilStalled(1, {0.8, 0.9, 0.9, 0.7, 0.9, 0.9, 0.6}), 0);
}

TEST(SettlingProgress, StallsWhereVerticesMoveToAndFro) {
  EXPECT_EQ(StepsUntilStalled(1, {0.8, 0.3, 0.31, 0.28, 0.3, 0.3}), 5);
}

TEST(SettlingProgress, GoesOnWhileMusclesMoveBeyondTheReach) {
  EXPECT_EQ(StepsUntilStalled(1, {1.5, 1.5, 1.5, 1.5, 1.5}), 0);
  EXPECT_EQ(StepsUntilStalled(2, {1.5, 1.5, 1.5, 1.5, 1.5}), 4);
}

}  // namespace
}  // namespace musclewarp
