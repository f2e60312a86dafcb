// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/invalid_option.h"

#include <gtest/gtest.h>

#include <limits>

namespace musclewarp {

TEST(InvalidOption, NamesFieldValueAndRule) {
  std::string error;
  EXPECT_FALSE(InvalidOption("SomeOptions::count", 0, "above 0", &error));
  EXPECT_EQ(error, "SomeOptions::count is 0, allowed: above 0");
}

TEST(InvalidOption, PrintsSmallAndOddNumbersAsTheyAre) {
  std::string error;
  InvalidOption("SomeOptions::tolerance", -1e-9, "above 0", &error);
  EXPECT_EQ(error, "SomeOptions::tolerance is -1e-09, allowed: above 0");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  InvalidOption("SomeOptions::share", nan, "0 to 1", &error);
  EXPECT_EQ(error, "SomeOptions::share is nan, allowed: 0 to 1");
}

}  // namespace musclewarp
