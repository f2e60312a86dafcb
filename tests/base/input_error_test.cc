// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/input_error.h"

#include <gtest/gtest.h>

namespace musclewarp {
namespace {

TEST(InputError, SaysWhereThenWhatThenWhatToDo) {
  const InputError error("a.ply: face 3", "has 2 corners", "export it again");
  EXPECT_STREQ(error.what(), "a.ply: face 3: has 2 corners; export it again");
}

TEST(InputError, KeepsItsParts) {
  const InputError error("a.ply: face 3", "has 2 corners", "export it again");
  const InputError copy(error);
  EXPECT_EQ(copy.where(), "a.ply: face 3");
  EXPECT_EQ(copy.problem(), "has 2 corners");
  EXPECT_EQ(copy.advice(), "export it again");
}

TEST(InputError, IsCaughtAsARuntimeError) {
  EXPECT_THROW(throw InputError("a", "b", "c"), std::runtime_error);
}

}  // namespace
}  // namespace musclewarp
