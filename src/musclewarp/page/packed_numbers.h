// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Packs the vertex positions of all frames so small that a page can carry them.
//
// Every number is an integer and is stored as its difference to the number
// `stride` places before it (to 0 for the first ones). The difference is zigzag
// coded (0, -1, 1, -2, ... become 0, 1, 2, 3, ...) and written in groups of 7
// bits, lowest first, where the top bit of a byte says that more follow. With
// the stride of a frame, vertices that move little take a byte per coordinate,
// which deflate shortens further. tools/report/src/data/numbers.ts is the
// reader.
//
//   PackedNumbers packed;
//   json["poses"] = packed.Add(positions, 3 * num_vertices);
//   json["triangles"] = packed.Add(mesh.triangles);
//   page_numbers = packed.Base64();
class PackedNumbers {
 public:
  // Adds a list of numbers. Returns where it is, for the JSON of the page:
  // { "at": first byte, "count": of numbers, "stride" }.
  nlohmann::ordered_json Add(const std::vector<int>& numbers, int stride);

  // Adds the indices of triangles, three to a triangle.
  nlohmann::ordered_json Add(const Triangles& triangles);

  // Returns all bytes so far as DeflatedBase64().
  std::string Base64() const;

 private:
  std::string bytes_;
};

// Returns bytes deflated (zlib, RFC 1950), as base64.
std::string DeflatedBase64(const std::string& bytes);

// Appends the multiples of `step` (mm) nearest to the coordinates of points,
// three to a point, to `numbers`. Precondition (CHECKed): they fit 30 bits.
void AppendRounded(const Points& points,
                   double step,
                   std::vector<int>* numbers);

}  // namespace musclewarp
