// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/element_names.h"

#include <gtest/gtest.h>

namespace musclewarp {
namespace {

TEST(ElementNames, KeepNamesThatAreFine) {
  ElementNames names;
  EXPECT_EQ(names.Of("psoas_major_r"), "psoas_major_r");
  EXPECT_EQ(names.Of("psoas_major_r"), "psoas_major_r");
}

TEST(ElementNames, ReplaceWhatFilesDoNotTake) {
  ElementNames names;
  EXPECT_EQ(names.Of("m. psoas, \"upper\""), "m__psoas___upper_");
  EXPECT_EQ(names.Of("3rd"), "m_3rd");
  EXPECT_EQ(names.Of(""), "m_");
  EXPECT_EQ(names.Of("\xc3\xa9"), "m___");
  EXPECT_EQ(names.Of(std::string(200, 'x')), std::string(64, 'x'));
}

TEST(ElementNames, DifferAlsoWithoutCase) {
  ElementNames names;
  EXPECT_EQ(names.Of("soleus"), "soleus");
  EXPECT_EQ(names.Of("Soleus"), "Soleus_2");
  EXPECT_EQ(names.Of("a b"), "a_b");
  EXPECT_EQ(names.Of("a-b"), "a_b_2");
  EXPECT_EQ(names.Of("a b"), "a_b");
}

}  // namespace
}  // namespace musclewarp
