// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/joint_sign.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "musclewarp/base/angles.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr JointSign kAngle =
    Below(60, 30)
        .Weak("covers {value} degrees, {limit} are expected: {cause}")
        .Failed("covers {value} degrees, {limit} are needed")
        .From("it is cut", "a test");

TEST(JointSign, WeakensOrFailsAVerdictWithItsSentence) {
  JointVerdict verdict;
  EXPECT_EQ(Judge({{kAngle, 75}}, &verdict), JointQuality::kGood);
  EXPECT_THAT(verdict.reasons, IsEmpty());
  EXPECT_EQ(Judge({{kAngle, 55}}, &verdict), JointQuality::kWeak);
  EXPECT_EQ(verdict.quality, JointQuality::kWeak);
  EXPECT_EQ(Judge({{kAngle, 25}}, &verdict), JointQuality::kFailed);
  EXPECT_EQ(verdict.quality, JointQuality::kFailed);
  EXPECT_THAT(verdict.reasons,
              ElementsAre("covers 55 degrees, 60 are expected: it is cut",
                          "covers 25 degrees, 30 are needed"));
}

TEST(JointSign, IsNotPassedByRounding) {
  // 12 sectors of 5 degrees, which are 59.99999999999999 degrees.
  const double sectors = DegreesOf(12 * 2 * M_PI / 72);
  EXPECT_EQ(QualityOf({kAngle, sectors}), JointQuality::kGood);
}

TEST(JointSign, HasLimitsThatFollowASize) {
  constexpr JointSign kReach =
      Above(1.5).Digits(1).Weak("{value} mm, {limit} mm are expected");
  JointVerdict verdict;
  EXPECT_EQ(Judge({{kReach, 29, 20}}, &verdict), JointQuality::kGood);
  EXPECT_EQ(Judge({{kReach, 31, 20}}, &verdict), JointQuality::kWeak);
  EXPECT_THAT(verdict.reasons, ElementsAre("31.0 mm, 30.0 mm are expected"));
}

TEST(JointSign, SpeaksForThoseThatAreJudgedWithIt) {
  constexpr JointSign kFirst =
      Above(10).Weak("{value} and {value2} of {what}, {limit} and {limit2}");
  constexpr JointSign kSecond = Above(2).Digits(1);
  JointVerdict verdict;
  Judge({{kFirst, 4}, {kSecond, 3}}, &verdict, {{"what", "both"}});
  EXPECT_THAT(verdict.reasons, ElementsAre("4 and 3.0 of both, 10 and 2"));
}

TEST(JointSign, IsAnObservationWithoutAMeasure) {
  JointVerdict verdict;
  Judge({{WeakIf("no axes")}}, &verdict);
  EXPECT_EQ(verdict.quality, JointQuality::kWeak);
  Judge({{FailedIf("no head")}}, &verdict);
  EXPECT_EQ(verdict.quality, JointQuality::kFailed);
  Judge({{FailedIf("no neck"), 0}}, &verdict);
  EXPECT_THAT(verdict.reasons, ElementsAre("no axes", "no head"));
}

TEST(FilledText, HasWordsAndNumbersOfSearches) {
  EXPECT_EQ(FilledText("{a} within {reach} mm", {{"a", "bones"}}),
            "bones within 6 mm");
  EXPECT_DEATH(FilledText("{nothing}"), "no word \\{nothing\\}");
}

}  // namespace
}  // namespace musclewarp
