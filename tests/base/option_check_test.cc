// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/option_check.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace musclewarp {
namespace {

TEST(OptionCheck, SaysNothingWhereAllIsWell) {
  std::string error = "untouched";
  EXPECT_TRUE(OptionCheck("Options", &error)
                  .IsAbove("a", 1e-9, 0)
                  .IsAtLeast("b", 0, 0)
                  .IsWithin("c", 1, 0, 1)
                  .is_valid());
  EXPECT_EQ(error, "untouched");
}

TEST(OptionCheck, NamesFieldValueAndRuleOfTheFirstThatIsWrong) {
  std::string error;
  EXPECT_FALSE(OptionCheck("Options", &error)
                   .IsAtLeast("b", 2, 1)
                   .IsAbove("a", -0.5, 0)
                   .IsWithin("c", 9, 0, 1)
                   .is_valid());
  EXPECT_EQ(error, "Options::a is -0.5, allowed: above 0");
  EXPECT_FALSE(OptionCheck("Options", &error).IsAtLeast("b", 0, 1).is_valid());
  EXPECT_EQ(error, "Options::b is 0, allowed: 1 or above");
  EXPECT_FALSE(
      OptionCheck("Options", &error).IsWithin("c", 1.5, 0, 1).is_valid());
  EXPECT_EQ(error, "Options::c is 1.5, allowed: 0 to 1");
}

TEST(OptionCheck, ANumberThatIsNoneBreaksEveryRule) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::string error;
  EXPECT_FALSE(OptionCheck("O", &error).IsAbove("x", nan, 0).is_valid());
  EXPECT_FALSE(OptionCheck("O", &error).IsAtLeast("x", nan, 0).is_valid());
  EXPECT_FALSE(OptionCheck("O", &error).IsWithin("x", nan, 0, 1).is_valid());
  EXPECT_EQ(error, "O::x is nan, allowed: 0 to 1");
}

}  // namespace
}  // namespace musclewarp
