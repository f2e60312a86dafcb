// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/content_hash.h"

#include <gtest/gtest.h>

namespace musclewarp {
namespace {

std::string HashOf(const std::vector<std::string>& texts) {
  ContentHash hash;
  for (const std::string& text : texts) hash.Add(text);
  return hash.Hex();
}

TEST(ContentHash, DependsOnEveryByteAndOnWhereTextsEnd) {
  EXPECT_EQ(HashOf({"ab", "c"}), HashOf({"ab", "c"}));
  EXPECT_NE(HashOf({"ab", "c"}), HashOf({"a", "bc"}));
  EXPECT_NE(HashOf({"ab"}), HashOf({"ab", ""}));
  EXPECT_NE(HashOf({"ab"}), HashOf({"aB"}));
  EXPECT_EQ(HashOf({}).size(), 16u);
}

}  // namespace
}  // namespace musclewarp
