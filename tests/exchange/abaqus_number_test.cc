// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/abaqus_number.h"

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <random>

namespace musclewarp {
namespace {

double NumberOf(const std::string& text) {
  double value = 0;
  const auto result =
      std::from_chars(text.data(), text.data() + text.size(), value);
  EXPECT_EQ(result.ptr, text.data() + text.size()) << text;
  return value;
}

// Of either sign, with random digits, and of the size 10^exponent.
double DrawNumber(int exponent, std::mt19937* random) {
  std::uniform_real_distribution<double> mantissa(1, 10);
  const double sign = (*random)() % 2 == 0 ? 1 : -1;
  return sign * mantissa(*random) * std::pow(10.0, exponent);
}

// Fourteen digits round by at most half of the last of them.
constexpr double kFourteenDigits = 0.5e-13;
constexpr double kThirteenDigits = 0.5e-12;

TEST(AbaqusNumber, FitsAndLosesNoMoreThanHasNoRoom) {
  std::mt19937 random(3);
  for (int exponent = -300; exponent <= 300; ++exponent) {
    const double allowed =
        std::abs(exponent) < 99 ? kFourteenDigits : kThirteenDigits;
    for (int i = 0; i < 20; ++i) {
      const double value = DrawNumber(exponent, &random);
      const std::string text = AbaqusNumber(value);
      EXPECT_LE(text.size(), 20u);
      EXPECT_LE(std::abs(NumberOf(text) / value - 1), 1.001 * allowed) << text;
    }
  }
}

TEST(AbaqusNumber, KeepsEveryBitOfOrdinaryCoordinates) {
  std::mt19937 random(5);
  for (int exponent = -1; exponent <= 8; ++exponent) {
    for (int i = 0; i < 100; ++i) {
      const double value = DrawNumber(exponent, &random);
      EXPECT_EQ(NumberOf(AbaqusNumber(value)), value);
    }
  }
}

TEST(AbaqusNumber, IsShortWhereItCanBe) {
  EXPECT_EQ(AbaqusNumber(0), "0");
  EXPECT_EQ(AbaqusNumber(-1.25), "-1.25");
  EXPECT_EQ(AbaqusNumber(0.1), "0.1");
  EXPECT_EQ(AbaqusNumber(1.0 / 3, 9), "0.333333333");
}

// CalculiX stopped at the first and took the second for -7.6.
TEST(AbaqusNumber, CutsDigitsAndNotTheExponent) {
  EXPECT_EQ(AbaqusNumber(4.6374671874097848e-05), "4.63746718740978e-05");
  EXPECT_EQ(AbaqusNumber(-7.61363549309262e-05), "-7.6136354930926e-05");
}

}  // namespace
}  // namespace musclewarp
