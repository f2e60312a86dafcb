// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Whole numbers packed for the page: each is stored as its difference to the
// one `stride` places before (0 for the first), zigzag coded (0, -1, 1, -2, ...
// become 0, 1, 2, 3, ...), in groups of 7 bits, lowest first, the top bit of a
// byte set if more follow. What moves little from frame to frame is short then,
// and deflate makes it shorter. tools/report/src/numbers.ts reads it.
class PackedNumbers {
 public:
  // Returns where the numbers are: { "at": byte, "count", "stride" }.
  nlohmann::ordered_json Add(const std::vector<int>& numbers, int stride);

  // The indices of triangles, three to one.
  nlohmann::ordered_json Add(const Triangles& triangles);

  // All bytes, deflated (zlib, RFC 1950), as base64.
  std::string Base64() const;

 private:
  std::string bytes_;
};

// Multiples of `step` next to the coordinates, three to a point, appended to
// `numbers`. Precondition (CHECKed): they fit 30 bits.
void AppendRounded(const Points& points,
                   double step,
                   std::vector<int>* numbers);

}  // namespace musclewarp
