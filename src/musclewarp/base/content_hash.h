// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace musclewarp {

// Tells different contents apart: 64 bit FNV-1a (Fowler, Noll and Vo). Not
// against those who try to make two alike.
class ContentHash {
 public:
  // The length goes in as well, so that "ab", "c" differs from "a", "bc".
  void Add(std::string_view bytes);

  std::string Hex() const;  // 16 digits

 private:
  void AddByte(unsigned char byte) {
    value_ = (value_ ^ byte) * 0x100000001b3u;
  }
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

}  // namespace musclewarp
