// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/settings/checked_settings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/input_errors.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(ChoicesOf, ReadsWhatFieldsList) {
  const Choices one = ChoicesOf("auto, never");
  EXPECT_THAT(one.words, ElementsAre("auto", "never"));
  EXPECT_FALSE(one.takes_several);
  const Choices several = ChoicesOf("ply, obj; commas");
  EXPECT_THAT(several.words, ElementsAre("ply", "obj"));
  EXPECT_TRUE(several.takes_several);
  EXPECT_THAT(ChoicesOf("").words, IsEmpty());
}

// A field says by "; commas" alone whether its text is a list.
TEST(CheckChoice, AllowsSeveralWordsWhereTheFieldDoes) {
  CheckChoice("format", "obj,ply", "ply, obj; commas");
  ExpectInputError([] { CheckChoice("format", "obj,ply", "ply, obj"); },
                   {"--format=obj,ply: is none of its values; allowed: ply, "
                    "obj"});
  for (const char* value : {"obj,stl", "", ",", "obj,,ply", "ply, obj"}) {
    ExpectInputError([&] { CheckChoice("format", value, "ply, obj; commas"); },
                     {"allowed: ply, obj, or several with commas"});
  }
}

}  // namespace
}  // namespace musclewarp
