// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace musclewarp {

// Appends the character with this number in Unicode, in UTF-8.
void AppendUtf8(std::uint32_t c, std::string* text);

// Returns a text in UTF-16 as UTF-8, without the mark at its beginning (byte
// order mark). Halves of pairs become U+FFFD; an odd byte at the end is left
// out.
std::string Utf8FromUtf16(const std::string& bytes, bool is_big_endian);

// Returns the bytes of a text file as UTF-8 without a mark: those with the mark
// of UTF-16, of either byte order, are converted, those without a mark are
// returned as they are.
std::string TextWithoutMark(const std::string& bytes);

}  // namespace musclewarp
