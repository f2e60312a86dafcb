// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/settling_muscles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// Adds moves of one muscle, mm, until it has settled. Returns their number, or
// 0.
int StepsUntilSettled(double reach, const std::vector<double>& moves) {
  SettlingMuscles muscle(1, /*tolerance=*/0.05, reach);
  for (size_t i = 0; i < moves.size(); ++i) {
    muscle.Add({moves[i]}, {});
    if (muscle.AreSettled()) return static_cast<int>(i) + 1;
  }
  return 0;
}

TEST(SettlingMuscles, SettleWithinTheTolerance) {
  EXPECT_EQ(StepsUntilSettled(1, {0.8, 0.4, 0.049}), 3);
  EXPECT_EQ(StepsUntilSettled(1, {0.01}), 1);
}

TEST(SettlingMuscles, GoOnWhileMovesShrink) {
  EXPECT_EQ(StepsUntilSettled(1, {0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2, 0.1}), 0);
  // Every third one is less than 0.9 of the least before.
  EXPECT_EQ(StepsUntilSettled(1, {0.8, 0.9, 0.9, 0.7, 0.9, 0.9, 0.6}), 0);
}

TEST(SettlingMuscles, SettleWhereVerticesMoveToAndFro) {
  EXPECT_EQ(StepsUntilSettled(1, {0.8, 0.3, 0.31, 0.28, 0.3, 0.3}), 5);
}

TEST(SettlingMuscles, GoOnWhileMusclesMoveBeyondTheReach) {
  EXPECT_EQ(StepsUntilSettled(1, {1.5, 1.5, 1.5, 1.5, 1.5}), 0);
  EXPECT_EQ(StepsUntilSettled(2, {1.5, 1.5, 1.5, 1.5, 1.5}), 4);
}

TEST(SettlingMuscles, StandStillWhileOthersSettle) {
  SettlingMuscles muscles(3, /*tolerance=*/0.1, /*reach=*/1);
  EXPECT_THAT(muscles.Still(), IsEmpty());
  muscles.Add({0.5, 0.05, 0.3}, muscles.Still());
  EXPECT_FALSE(muscles.AreSettled());
  EXPECT_THAT(muscles.Still(), ElementsAre(false, true, false));
  muscles.Add({0.2, 0, 0.05}, muscles.Still());
  EXPECT_THAT(muscles.Still(), ElementsAre(false, true, true));
  // All may be asked to move once more.
  muscles.MoveAll();
  EXPECT_THAT(muscles.Still(), IsEmpty());
  muscles.Add({0.05, 0.4, 0.05}, muscles.Still());
  EXPECT_THAT(muscles.Still(), ElementsAre(true, false, true));
  muscles.Add({0, 0.05, 0}, muscles.Still());
  EXPECT_TRUE(muscles.AreSettled());
  EXPECT_THAT(muscles.Still(), IsEmpty());
}

TEST(SettlingMuscles, StaySettledWhileOthersMoveThemALittle) {
  SettlingMuscles muscles(2, /*tolerance=*/0.1, /*reach=*/1);
  muscles.Add({0.05, 0.05}, muscles.Still());
  EXPECT_TRUE(muscles.AreSettled());
  muscles.MoveAll();
  muscles.Add({0.25, 0.05}, muscles.Still());
  EXPECT_TRUE(muscles.AreSettled());
  muscles.MoveAll();
  muscles.Add({0.35, 0.05}, muscles.Still());
  EXPECT_FALSE(muscles.AreSettled());
}

TEST(SettlingMuscles, MayBeginWithSomeOfThem) {
  SettlingMuscles muscles(2, /*tolerance=*/0.1, /*reach=*/1);
  muscles.MoveOnly({true, false});
  EXPECT_FALSE(muscles.AreSettled());
  EXPECT_THAT(muscles.Still(), ElementsAre(false, true));
  muscles.MoveOnly({false, false});
  EXPECT_THAT(muscles.Still(), IsEmpty());
}

}  // namespace
}  // namespace musclewarp
