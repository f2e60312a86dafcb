// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/content_hash.h"

#include <iomanip>
#include <sstream>

namespace musclewarp {

void ContentHash::Add(std::string_view bytes) {
  for (std::uint64_t size = bytes.size(), i = 0; i < 8; ++i) {
    AddByte(static_cast<unsigned char>(size >> (8 * i)));
  }
  for (const char c : bytes) AddByte(static_cast<unsigned char>(c));
}

std::string ContentHash::Hex() const {
  std::ostringstream hex;
  hex << std::hex << std::setfill('0') << std::setw(16) << value_;
  return hex.str();
}

}  // namespace musclewarp
