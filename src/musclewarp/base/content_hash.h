// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace musclewarp {

// A checksum of the inputs of a run, by which a later run recognises that the
// results on disk belong to the same inputs. It is the 64-bit FNV-1a hash of
// Fowler, Noll and Vo: it tells accidental changes apart, but offers no
// protection against inputs that are made to collide.
//
//   ContentHash hash;
//   hash.Add(ReadFile("scene.json"));
//   hash.Add("--contact=none");
//   report["inputs_hash"] = hash.Hex();
class ContentHash {
 public:
  // Adds a piece of input. The length is hashed as well, so that the pieces
  // "ab", "c" give another hash than "a", "bc".
  void Add(std::string_view bytes);

  // Returns the hash of all pieces so far as 16 lower-case hexadecimal digits.
  std::string Hex() const;

 private:
  void AddByte(unsigned char byte) {
    value_ = (value_ ^ byte) * 0x100000001b3u;
  }
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

}  // namespace musclewarp
