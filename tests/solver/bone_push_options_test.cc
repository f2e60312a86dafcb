// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/bone_push_options.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace musclewarp {
namespace {

std::string ErrorOf(const BonePushOptions& options) {
  std::string error;
  const bool is_valid = options.IsValid(&error);
  EXPECT_EQ(is_valid, error.empty());
  return error;
}

TEST(BonePushOptions, AreValidByDefault) { EXPECT_EQ(ErrorOf({}), ""); }

TEST(BonePushOptions, NameTheFieldThatIsNotAllowed) {
  BonePushOptions options;
  options.onset = 0;
  EXPECT_EQ(ErrorOf(options), "BonePushOptions::onset is 0, allowed: above 0");
  options = {};
  options.clearance = NAN;
  EXPECT_EQ(ErrorOf(options),
            "BonePushOptions::clearance is nan, allowed: 0 or above");
  options = {};
  options.steps_per_pose = 0;
  EXPECT_NE(ErrorOf(options).find("steps_per_pose is 0"), std::string::npos);
}

}  // namespace
}  // namespace musclewarp
