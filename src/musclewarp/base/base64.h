// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace musclewarp {

// Binary data as text (RFC 4648, section 4: the alphabet with '+' and '/'), for
// the report page and for the arrays of .vtp files.

// Returns the encoding of `bytes` with padding, in a single line.
std::string EncodeBase64(std::string_view bytes);

// Returns the bytes that `text` encodes, and stops at the first character that
// is neither a base64 character nor a blank. Blanks between characters are
// skipped, and the text may hold several encodings in a row, each padded by
// itself: VTK encodes the header of an array and its data separately.
std::string DecodeBase64(std::string_view text);

}  // namespace musclewarp
