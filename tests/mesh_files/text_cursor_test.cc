// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/text_cursor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "support/input_errors.h"

namespace musclewarp {
namespace {

double RealOf(std::string_view word) {
  return TextCursor("a.obj", "").Real(word, "a coordinate");
}

TEST(TextCursor, LinesMayEndInThreeWays) {
  TextCursor cursor("a", "one\ntwo\r\nthree\rfour");
  std::string_view line;
  for (const char* expected : {"one", "two", "three", "four"}) {
    ASSERT_TRUE(cursor.NextLine(&line));
    EXPECT_EQ(line, expected);
  }
  EXPECT_EQ(cursor.line(), 4u);
  EXPECT_FALSE(cursor.NextLine(&line));
}

TEST(TextCursor, EmptyLinesAreLinesWithoutWords) {
  TextCursor cursor("a", "\n\n  \t\na  b\n");
  Words words;
  ASSERT_TRUE(cursor.NextWords(&words));
  EXPECT_EQ(words, (Words{"a", "b"}));
  EXPECT_EQ(cursor.line(), 4u);
  EXPECT_FALSE(cursor.NextWords(&words));
  EXPECT_TRUE(words.empty());
}

TEST(TextCursor, CommentsEndWithTheirLine) {
  TextCursor cursor("a", "# all of it\na b# c\nd#\n", '#');
  Words words;
  ASSERT_TRUE(cursor.NextWords(&words));
  EXPECT_EQ(words, (Words{"a", "b"}));
  ASSERT_TRUE(cursor.NextWords(&words));
  EXPECT_EQ(words, (Words{"d"}));
  EXPECT_EQ(cursor.line(), 3u);
}

TEST(TextCursor, WordsKnowTheirLine) {
  TextCursor cursor("a.stl", "a b\r\n\r\nc\n");
  std::string_view word;
  std::vector<std::size_t> lines;
  while (cursor.NextWord(&word)) lines.push_back(cursor.line());
  EXPECT_EQ(lines, (std::vector<std::size_t>{1, 1, 3}));
  EXPECT_EQ(cursor.Where(), "a.stl: line 3");
}

TEST(TextCursor, ALineAfterAWordIsItsRest) {
  TextCursor cursor("a", "solid a name\nfacet\n");
  std::string_view word, line;
  ASSERT_TRUE(cursor.NextWord(&word));
  ASSERT_TRUE(cursor.NextLine(&line));
  EXPECT_EQ(line, " a name");
  EXPECT_EQ(cursor.line(), 1u);
}

TEST(TextCursor, BehindBinaryDataBytesAreCounted) {
  TextCursor cursor("a.vtk", std::string_view("head\n\n\0\nx", 9));
  std::string_view line;
  cursor.NextLine(&line);
  EXPECT_EQ(cursor.TakeBytes(3), std::string_view("\n\0\n", 3));
  EXPECT_EQ(cursor.bytes_left(), 1u);
  EXPECT_EQ(cursor.Where(), "a.vtk: byte 8");
}

TEST(TextCursorDeathTest, BytesThatAreNotThereAreAProgrammerError) {
  TextCursor cursor("a", "abc");
  EXPECT_DEATH(cursor.TakeBytes(4), "bytes_left");
}

TEST(TextCursor, RealsAreRoundedToTheNearestDouble) {
  EXPECT_EQ(RealOf("0.1"), 0.1);
  EXPECT_EQ(RealOf("+1.5e3"), 1500);
  EXPECT_TRUE(std::signbit(RealOf("-0")));
  EXPECT_TRUE(std::isnan(RealOf("nan")));
  EXPECT_EQ(RealOf("1e999"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(RealOf("1e-999"), 0);
}

TEST(TextCursor, WhatIsNoNumberIsQuotedWithWhatWasExpected) {
  for (const char* word : {"1,5", "x", "", "1.5mm", "+-1", "0x10"}) {
    ExpectInputError([&] { RealOf(word); },
                     {"a.obj: line 0",
                      "'" + std::string(word) + "'",
                      "a coordinate",
                      "a number"});
  }
}

TEST(TextCursor, IntegersAreWhole) {
  const TextCursor cursor("a", "");
  EXPECT_EQ(cursor.Integer("-9223372036854775808", "an index"),
            std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(cursor.Integer("+7", "an index"), 7);
  for (const char* word : {"7.0", "9223372036854775808", "seven", ""}) {
    ExpectInputError([&] { cursor.Integer(word, "an index"); },
                     {"an index", "a whole number"});
  }
}

TEST(AppendReal, GivesTheSameDoubleAgain) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 1000; ++i) {
    const std::uint64_t bits = random();
    double value;
    std::memcpy(&value, &bits, sizeof(value));
    if (!std::isfinite(value)) continue;
    std::string text;
    AppendReal(value, &text);
    EXPECT_EQ(RealOf(text), value) << text;
  }
}

TEST(Quoted, CutsAndEscapes) {
  EXPECT_EQ(Quoted("abc"), "'abc'");
  EXPECT_EQ(Quoted(std::string_view("a\n\0\xff", 4)), "'a\\x0a\\x00\\xff'");
  EXPECT_EQ(Quoted("abcdefghijklmnopqrstuvwxyz"),
            "'abcdefghijklmnopqrstuvwx...'");
}

TEST(LowerCase, LeavesAllButAsciiLetters) {
  EXPECT_EQ(LowerCase("PolyData_3 \xc4"), "polydata_3 \xc4");
}

}  // namespace
}  // namespace musclewarp
