// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/near_name.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace musclewarp {
namespace {

const std::vector<std::string> kWords = {
    "", "a", "femur", "femur_r", "fibula_r", "scapula", "fem", "rumef"};

// Else "nearest" would depend on which of two names is asked for.
TEST(EditDistance, IsSymmetricAndZeroForEqualTextsOnly) {
  for (const std::string& a : kWords) {
    for (const std::string& b : kWords) {
      const int distance = EditDistance(a, b);
      EXPECT_EQ(distance == 0, a == b) << a << " " << b;
      EXPECT_EQ(distance, EditDistance(b, a)) << a << " " << b;
    }
  }
}

TEST(EditDistance, CountsLettersAddedRemovedReplacedAndSwapped) {
  EXPECT_EQ(EditDistance("", "femur"), 5);
  EXPECT_EQ(EditDistance("femur", "femr"), 1);
  EXPECT_EQ(EditDistance("femur", "fimur"), 1);
  EXPECT_EQ(EditDistance("femur", "femur_r"), 2);
  EXPECT_EQ(EditDistance("femur", "fmeur"), 1);
}

// One letter off is the most frequent slip, whichever letter it is.
TEST(NearName, UndoesEverySlipOfOneLetter) {
  const std::vector<std::string> known = {"tibia_r", "femur_r", "scapula"};
  for (size_t i = 0; i < known[1].size(); ++i) {
    std::string without = known[1], other = known[1], more = known[1];
    without.erase(i, 1);
    other[i] = 'x';
    more.insert(i, "x");
    for (const std::string& slip : {without, other, more}) {
      EXPECT_EQ(NearName(slip, known), "femur_r") << slip;
    }
  }
}

TEST(NearName, FindsEachKnownNameItself) {
  for (const std::string& word : kWords) {
    EXPECT_EQ(NearName(word, kWords), word);
  }
  EXPECT_EQ(NearName("FEMUR_R", kWords), "femur_r");
}

// A guess that shares little with what was written would only mislead.
TEST(NearName, IsEmptyIfMoreThanAThirdWouldChange) {
  const std::vector<std::string> known = {"scene", "gap", "k"};
  EXPECT_EQ(NearName("scenery", known), "scene");   // 2 of 7
  EXPECT_EQ(NearName("sceneries", {"scene"}), "");  // 4 of 9
  EXPECT_EQ(NearName("colour", known), "");
  EXPECT_EQ(NearName("gab", known), "gap");
  EXPECT_EQ(NearName("job", known), "");
  EXPECT_EQ(NearName("j", known), "");  // all letters of one would change
  EXPECT_EQ(NearName("scene", {}), "");
}

TEST(NearName, PrefersTheNearestAndOfEqualOnesTheFirst) {
  EXPECT_EQ(NearName("femur_", {"femur_r", "femur_l"}), "femur_r");
  EXPECT_EQ(NearName("femur_rr", {"femur", "femur_r"}), "femur_r");
}

TEST(DidYouMean, AsksOnlyForNamesThatAreNear) {
  EXPECT_EQ(DidYouMean("scen", {"scene"}, "--"), "did you mean --scene? ");
  EXPECT_EQ(DidYouMean("colour", {"scene"}, "--"), "");
}

}  // namespace
}  // namespace musclewarp
