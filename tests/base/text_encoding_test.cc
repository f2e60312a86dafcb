// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/text_encoding.h"

#include <gtest/gtest.h>

namespace musclewarp {
namespace {

// UTF-16 with its mark.
std::string Utf16(const std::u16string& text, bool is_big_endian) {
  std::string bytes;
  for (const char16_t unit : u'\xfeff' + text) {
    const char high = static_cast<char>(unit >> 8);
    const char low = static_cast<char>(unit);
    bytes += is_big_endian ? high : low;
    bytes += is_big_endian ? low : high;
  }
  return bytes;
}

TEST(TextWithoutMark, IsTheSameFromAllEncodings) {
  // One to four bytes in UTF-8.
  const std::string text = "a;\u00fc;\u20ac;\U0001f9b4\r\n";
  EXPECT_EQ(TextWithoutMark(text), text);
  EXPECT_EQ(TextWithoutMark("\xef\xbb\xbf" + text), text);
  for (const bool is_big_endian : {false, true}) {
    EXPECT_EQ(TextWithoutMark(
                  Utf16(u"a;\u00fc;\u20ac;\U0001f9b4\r\n", is_big_endian)),
              text);
  }
}

TEST(TextWithoutMark, HalfPairsAreReplaced) {
  const std::u16string high(1, 0xd83e), low(1, 0xddb4);
  EXPECT_EQ(TextWithoutMark(Utf16(high + u"a", false)), "\ufffda");
  EXPECT_EQ(TextWithoutMark(Utf16(low + u"a", false)), "\ufffda");
  EXPECT_EQ(TextWithoutMark(Utf16(u"a" + high, true)), "a\ufffd");
  EXPECT_EQ(TextWithoutMark(Utf16(u"a", false) + "b"), "a");
}

TEST(TextWithoutMark, OtherBytesAreLeftAlone) {
  for (const std::string bytes : {"", "\xef\xbb", "\xff", "\xfc;\x80"}) {
    EXPECT_EQ(TextWithoutMark(bytes), bytes);
  }
}

}  // namespace
}  // namespace musclewarp
