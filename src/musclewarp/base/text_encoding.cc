// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/text_encoding.h"

namespace musclewarp {
namespace {

constexpr std::uint32_t kReplacement = 0xfffd;

}  // namespace

void AppendUtf8(std::uint32_t c, std::string* text) {
  const auto more = [&](int shift) {
    *text += static_cast<char>(0x80 | ((c >> shift) & 0x3f));
  };
  if (c < 0x80) {
    *text += static_cast<char>(c);
  } else if (c < 0x800) {
    *text += static_cast<char>(0xc0 | c >> 6);
    more(0);
  } else if (c < 0x10000) {
    *text += static_cast<char>(0xe0 | c >> 12);
    more(6);
    more(0);
  } else {
    *text += static_cast<char>(0xf0 | c >> 18);
    more(12);
    more(6);
    more(0);
  }
}

std::string Utf8FromUtf16(const std::string& bytes, bool is_big_endian) {
  const auto unit = [&](size_t i) -> std::uint32_t {
    const auto a = static_cast<unsigned char>(bytes[2 * i]);
    const auto b = static_cast<unsigned char>(bytes[2 * i + 1]);
    return is_big_endian ? a << 8 | b : b << 8 | a;
  };
  std::string utf8;
  const size_t count = bytes.size() / 2;
  for (size_t i = 0; i < count; ++i) {
    std::uint32_t c = unit(i);
    if (c == 0xfeff && i == 0) continue;  // the mark
    if (c >= 0xd800 && c < 0xe000) {
      const std::uint32_t low = i + 1 < count ? unit(i + 1) : 0;
      const bool is_pair = c < 0xdc00 && low >= 0xdc00 && low < 0xe000;
      c = is_pair ? 0x10000 + ((c - 0xd800) << 10) + (low - 0xdc00)
                  : kReplacement;
      i += is_pair;
    }
    AppendUtf8(c, &utf8);
  }
  return utf8;
}

std::string TextWithoutMark(const std::string& bytes) {
  if (bytes.compare(0, 3, "\xef\xbb\xbf") == 0) return bytes.substr(3);
  if (bytes.compare(0, 2, "\xff\xfe") == 0) return Utf8FromUtf16(bytes, false);
  if (bytes.compare(0, 2, "\xfe\xff") == 0) return Utf8FromUtf16(bytes, true);
  return bytes;
}

}  // namespace musclewarp
