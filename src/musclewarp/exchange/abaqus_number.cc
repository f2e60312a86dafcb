// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/abaqus_number.h"

#include <charconv>

namespace musclewarp {
namespace {

// The digits from which every double is read again.
constexpr int kAllDigits = 17;

constexpr size_t kBufferSize = 32;

}  // namespace

std::string AbaqusNumber(double value, int most_digits) {
  char buffer[kBufferSize];
  char* const end = buffer + kBufferSize;
  if (most_digits >= kAllDigits) {
    const auto shortest = std::to_chars(buffer, end, value);
    if (shortest.ptr - buffer <= kMostAbaqusCharacters) {
      return {buffer, shortest.ptr};
    }
  }
  auto result = std::to_chars(
      buffer, end, value, std::chars_format::general, most_digits);
  while (result.ptr - buffer > kMostAbaqusCharacters) {
    result = std::to_chars(
        buffer, end, value, std::chars_format::general, --most_digits);
  }
  return {buffer, result.ptr};
}

}  // namespace musclewarp
