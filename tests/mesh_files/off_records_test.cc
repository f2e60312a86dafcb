// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/off_records.h"

#include <gtest/gtest.h>

#include "support/input_errors.h"

namespace musclewarp {
namespace {

OffLayout LayoutOf(const std::string& text) {
  TextCursor cursor("a.off", text, '#');
  const OffHeader header = ReadOffHeader("a.off", &cursor);
  return LayoutOfOff(header, cursor);
}

TEST(OffRecords, TheKeywordSaysHowLongAVertexIs) {
  const auto numbers = [](const std::string& text) {
    TextCursor cursor("a.off", text, '#');
    return NumbersOfVertex(ReadOffHeader("a.off", &cursor), 4);
  };
  EXPECT_EQ(numbers("OFF\n1 1 0\n"), 3);
  EXPECT_EQ(numbers("NOFF 1 1 0\n"), 6);
  EXPECT_EQ(numbers("STCNOFF BINARY\n"), 12);
  EXPECT_EQ(numbers("1 1 0\n"), 3);
}

TEST(OffRecords, OtherKeywordsAreRefused) {
  for (const char* word : {"OFFS", "ply", "NCOFF"}) {
    ExpectInputError([&] { LayoutOf(word + std::string("\n1 1 0\n")); },
                     {"a.off", "is not an OFF file", word});
  }
  ExpectInputError([] { LayoutOf("nOFF\n3\n1 1 0\n"); }, {"'nOFF'"});
}

TEST(OffRecords, LinesAreCountedAgainstTheHeader) {
  const std::string points = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(LayoutOf(points + "3 0 1 2 9\n"), OffLayout::kLines);
  EXPECT_EQ(LayoutOf(points + "3 0 1 # a comment\n\n2\n"), OffLayout::kOver);
  EXPECT_EQ(LayoutOf("OFF 3 1 0\n0 0 0 1 0 0 0 1 0\n3 0 1 2\n"),
            OffLayout::kStream);
  // A file that ends early is not taken for a stream.
  EXPECT_EQ(LayoutOf(points), OffLayout::kLines);
  EXPECT_EQ(LayoutOf("OFF 4000000000000000000 4000000000000000000 0\n1 2 3\n"),
            OffLayout::kLines);
}

}  // namespace
}  // namespace musclewarp
