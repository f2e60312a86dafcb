// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/step_length.h"

#include <gtest/gtest.h>

#include "support/invalid_options.h"

namespace musclewarp {

TEST(StepLengthSchedule, FallsByTheDecayToTheFinalLengthAndStaysThere) {
  const StepLengthSchedule schedule = {0.5, 0.2, 0.5};
  EXPECT_EQ(schedule.Next(0.5), 0.25);
  EXPECT_EQ(schedule.Next(0.25), 0.2);
  EXPECT_EQ(schedule.Next(0.2), 0.2);
}

TEST(StepLengthSchedule, IsConstantWithoutDecay) {
  const StepLengthSchedule schedule = {1, 0.1, 1};
  EXPECT_EQ(schedule.Next(schedule.initial_alpha), 1);
}

TEST(StepLengthSchedule, DefaultsAreThePapersAndValid) {
  ExpectValid(StepLengthSchedule());
  EXPECT_EQ(StepLengthSchedule().initial_alpha, 0.5);
  EXPECT_EQ(StepLengthSchedule().final_alpha, 0.125);
}

TEST(StepLengthSchedule, RefusesValuesOutOfRange) {
  ExpectRefused<StepLengthSchedule>(
      [](auto* schedule) { schedule->initial_alpha = 1.5; },
      "StepLengthSchedule::initial_alpha is 1.5, allowed: above 0 and at most "
      "1");
  ExpectRefused<StepLengthSchedule>(
      [](auto* schedule) { schedule->final_alpha = 0; },
      "StepLengthSchedule::final_alpha is 0, allowed: above 0 and at most "
      "initial_alpha");
  ExpectRefused<StepLengthSchedule>(
      [](auto* schedule) { schedule->final_alpha = 0.75; },
      "StepLengthSchedule::final_alpha is 0.75, allowed: above 0 and at most "
      "initial_alpha");
  ExpectRefused<StepLengthSchedule>(
      [](auto* schedule) { schedule->decay = 2; },
      "StepLengthSchedule::decay is 2, allowed: above 0 and at most 1");
}

}  // namespace musclewarp
