// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/legacy_vtk_arrays.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/input_errors.h"

namespace musclewarp {
namespace {

// The text behind the array, up to the end of its line.
std::string BehindArray(const std::string& type,
                        std::int64_t count,
                        bool is_binary,
                        const std::string& bytes) {
  TextCursor cursor("a.vtk", bytes);
  SkipLegacyVtkArray(type, count, is_binary, &cursor);
  Words words;
  cursor.NextWords(&words);
  return words.empty() ? "" : std::string(words[0]);
}

// As VTK writes a text in binary data, with this many bytes for its length.
std::string TextWithLength(const std::string& text, int length_bytes) {
  const int mark = length_bytes == 1   ? 3
                   : length_bytes == 2 ? 2
                   : length_bytes == 4 ? 1
                                       : 0;
  std::string bytes;
  for (int i = length_bytes - 1; i >= 0; --i) {
    bytes +=
        static_cast<char>(static_cast<std::uint64_t>(text.size()) >> (8 * i));
  }
  bytes[0] = static_cast<char>(bytes[0] | mark << 6);
  return bytes + text;
}

TEST(LegacyVtkArrays, TextsOfAsciiFilesAreLines) {
  EXPECT_EQ(BehindArray("string", 3, false, "a%20b\n\nc\nNEXT\n"), "NEXT");
  EXPECT_EQ(BehindArray("utf8_string", 1, false, "a\r\nNEXT\r\n"), "NEXT");
  EXPECT_EQ(BehindArray("string", 0, false, "\nNEXT\n"), "NEXT");
}

TEST(LegacyVtkArrays, TextsOfBinaryFilesHaveTheirLengths) {
  for (const int length_bytes : {1, 2, 4, 8}) {
    const std::string text = length_bytes == 1 ? "L\nS" : std::string(300, 'x');
    const std::string bytes = TextWithLength(text, length_bytes) +
                              TextWithLength("", length_bytes) + "\nNEXT\n";
    EXPECT_EQ(BehindArray("string", 2, true, bytes), "NEXT") << length_bytes;
  }
}

TEST(LegacyVtkArrays, VariantsAreLinesInAllFiles) {
  for (const bool is_binary : {false, true}) {
    EXPECT_EQ(BehindArray("variant", 2, is_binary, "11 1.5\n13 a%20b\nNEXT\n"),
              "NEXT");
  }
}

TEST(LegacyVtkArrays, EightBitsAreAByte) {
  EXPECT_EQ(BehindArray("bit", 9, true, "ab\nNEXT\n"), "NEXT");
  EXPECT_EQ(BehindArray("bit", 3, false, "0 1\n1\nNEXT\n"), "NEXT");
}

TEST(LegacyVtkArrays, TruncatedOnesAreRefused) {
  const std::string text = TextWithLength("abc", 1);
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"string", ""},
      {"string", text.substr(0, 3)},
      {"string", TextWithLength("abc", 8).substr(0, 5)},
      {"string", std::string(1, '\x3f') + std::string(7, '\xff')},
      {"double", "1234567"},
      {"bit", ""},
      {"variant", ""}};
  for (const auto& [type, bytes] : cases) {
    ExpectInputError([&] { BehindArray(type, 1, true, bytes); },
                     {"a.vtk", "FIELD promises 1", "truncated"});
  }
  ExpectInputError([&] { BehindArray("string", 2, false, "a\n"); },
                   {"FIELD promises 2", "truncated"});
}

TEST(LegacyVtkArrays, UnknownTypesAreNamed) {
  ExpectInputError([&] { BehindArray("quaternion", 1, true, "abcdefgh"); },
                   {"a.vtk", "'quaternion' is not a number type"});
}

}  // namespace
}  // namespace musclewarp
