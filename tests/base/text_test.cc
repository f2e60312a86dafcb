// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(PlaceText, HasATenthOfAMillimetreOfAHuman) {
  EXPECT_EQ(PlaceText({1, -2.25, 300}), "(1.0, -2.2, 300.0)");
  EXPECT_EQ(PlaceText({32, -64, 1}, 1.0 / 32), "(1.000, -2.000, 0.031)");
  EXPECT_EQ(PlaceText({1, 2, 3}, 16), "(16.0, 32.0, 48.0)");
}

TEST(MeasureText, HasThreeDigitsOrAllBeforeThePoint) {
  EXPECT_EQ(MeasureText(26.66), "26.7");
  EXPECT_EQ(MeasureText(0.005123), "0.00512");
  EXPECT_EQ(MeasureText(30), "30");
  EXPECT_EQ(MeasureText(999.7), "1000");
  EXPECT_EQ(MeasureText(-255012.4), "-255012");
  EXPECT_EQ(MeasureText(0), "0");
}

TEST(FixedText, HasThreeSignificantDigitsAtLeast) {
  EXPECT_EQ(FixedText(43.62, 1), "43.6");
  EXPECT_EQ(FixedText(0.0054321, 1), "0.00543");
  EXPECT_EQ(FixedText(1234.5678, 3), "1234.568");
  EXPECT_EQ(FixedText(0, 2), "0.00");
  EXPECT_EQ(FixedText(2e-14, 3), "0.000");
  EXPECT_EQ(FixedText(0.000012345, 1), "0.000012");
}

TEST(NumberText, HasSixDigitsOrAsManyAsAsked) {
  EXPECT_EQ(NumberText(0.25), "0.25");
  EXPECT_EQ(NumberText(2e7), "2e+07");
  EXPECT_EQ(NumberText(1.0 / 3), "0.333333");
  EXPECT_EQ(NumberText(0.1, 17), "0.10000000000000001");
}

TEST(RoundedText, HasSoManyDigitsBehindThePoint) {
  EXPECT_EQ(RoundedText(12.345, 1), "12.3");
  EXPECT_EQ(RoundedText(1e-9, 2), "0.00");
  EXPECT_EQ(RoundedText(0.03125, 1, 1.0 / 32), "0.031");
}

TEST(DegreesText, IsOfAnAngleInRadians) {
  EXPECT_EQ(DegreesText(M_PI / 3), "60 degrees");
  EXPECT_EQ(DegreesText(0.1, 1), "5.7 degrees");
}

TEST(LengthText, IsInMillimetres) {
  EXPECT_EQ(LengthText(3.25), "3.25 mm");
  EXPECT_EQ(LengthText(16, 1.0 / 32), "0.5 mm");
}

TEST(BodySizeText, IsAFractionOrATimes) {
  EXPECT_EQ(BodySizeText(1.0 / 32), "1/32 of");
  EXPECT_EQ(BodySizeText(16), "16 times");
}

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
