// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/short_list.h"

#include <gtest/gtest.h>

namespace musclewarp {
namespace {

TEST(ShortList, NamesTheFirstAndCountsTheOthers) {
  EXPECT_EQ(ShortList({}), "");
  EXPECT_EQ(ShortList({"a"}), "a");
  EXPECT_EQ(ShortList({"a", "b"}, 2), "a, b");
  EXPECT_EQ(ShortList({"a", "b", "c", "d"}, 2), "a, b and 2 more");
}

}  // namespace
}  // namespace musclewarp
