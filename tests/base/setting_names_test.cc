// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/setting_names.h"

#include <gtest/gtest.h>

#include "musclewarp/base/input_error.h"

namespace musclewarp {
namespace {

TEST(SettingNames, DependOnTheCaller) {
  const std::string text = "give {max_hole} or {pieces}=all ({gap})";
  EXPECT_EQ(WithFlags(text), "give --max_hole or --pieces=all (--gap)");
  EXPECT_EQ(WithFieldNames(text), "give max_hole or pieces=all (gap)");
}

TEST(SettingNames, LeaveOtherBracesAlone) {
  for (const std::string text :
       {"", "{", "}", "{}", "{gap", "gap}", "{Gap}", "{2}", "{\"gap\":{}}"}) {
    EXPECT_EQ(WithFlags(text), text);
    EXPECT_EQ(WithFieldNames(text), text);
  }
  EXPECT_EQ(WithFlags("{{gap}"), "{--gap");
}

TEST(SettingNames, OfAnErrorAreFieldsOrFlags) {
  const InputError error("{gap}", "is 1", "see {max_hole}");
  EXPECT_STREQ(error.what(), "gap: is 1; see max_hole");
  EXPECT_EQ(error.WithFlags(), "--gap: is 1; see --max_hole");
  EXPECT_EQ(error.where(), "{gap}");
}

}  // namespace
}  // namespace musclewarp
