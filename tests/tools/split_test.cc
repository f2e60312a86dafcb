// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Split, GivesThePartsInTheirOrder) {
  EXPECT_THAT(Split("ply", ','), ElementsAre("ply"));
  EXPECT_THAT(Split("ply,obj,vtp", ','), ElementsAre("ply", "obj", "vtp"));
  EXPECT_THAT(Split("1:2,3", ':'), ElementsAre("1", "2,3"));
}

TEST(Split, KeepsEmptyPartsButTheLast) {
  EXPECT_THAT(Split("", ','), IsEmpty());
  EXPECT_THAT(Split(",", ','), ElementsAre(""));
  EXPECT_THAT(Split("a,,b", ','), ElementsAre("a", "", "b"));
  EXPECT_THAT(Split(",a", ','), ElementsAre("", "a"));
  EXPECT_THAT(Split("a,", ','), ElementsAre("a"));
}

TEST(Split, LeavesBlanksAlone) {
  EXPECT_THAT(Split(" a , b", ','), ElementsAre(" a ", " b"));
}

}  // namespace
}  // namespace musclewarp
