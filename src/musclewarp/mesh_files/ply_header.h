// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "musclewarp/mesh_files/binary_scalar.h"
#include "musclewarp/mesh_files/text_cursor.h"

namespace musclewarp {

// The header of a PLY file (G. Turk, "The PLY Polygon File Format", 1994).

enum class PlyFormat { kAscii, kBinaryLittle, kBinaryBig };

struct PlyProperty {
  std::string name;
  ScalarType type;  // Of the entries, if a list.
  bool is_list = false;
  ScalarType count_type = ScalarType::kUInt8;  // Only of lists.
};

struct PlyElement {
  std::string name;
  std::int64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::kAscii;
  std::vector<PlyElement> elements;
};

// Leaves the cursor behind the line "end_header". Throws InputError if this is
// no PLY header.
PlyHeader ReadPlyHeader(const std::string& path, TextCursor* cursor);

}  // namespace musclewarp
