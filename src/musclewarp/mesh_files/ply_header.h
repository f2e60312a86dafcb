// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "musclewarp/mesh_files/binary_scalar.h"
#include "musclewarp/mesh_files/text_cursor.h"

namespace musclewarp {

// The header of a PLY file (G. Turk, "The PLY Polygon File Format", 1994). It
// declares the elements that follow and the layout of each; a reader must know
// the layout of elements and properties even to skip them.

// How the data behind the header are encoded.
enum class PlyFormat { kAscii, kBinaryLittle, kBinaryBig };

// A property of an element: a single number, or a list that starts with its
// length.
struct PlyProperty {
  std::string name;
  // The type of the number, or of the entries of the list.
  ScalarType type;
  bool is_list = false;
  // The type of the length of a list.
  ScalarType count_type = ScalarType::kUInt8;
};

// An element ("vertex", "face", ...), of which the file holds `count` items,
// each with the properties in this order.
struct PlyElement {
  std::string name;
  std::int64_t count = 0;
  std::vector<PlyProperty> properties;
};

// The elements, in the order in which their data follow.
struct PlyHeader {
  PlyFormat format = PlyFormat::kAscii;
  std::vector<PlyElement> elements;
};

// Reads the header and leaves the cursor behind the line "end_header". Throws
// InputError if the text does not start with a PLY header, or if the header is
// cut off, declares an element twice, or has an unknown format or type. Lines
// of unknown kinds are skipped, unless properties follow.
PlyHeader ReadPlyHeader(const std::string& path, TextCursor* cursor);

}  // namespace musclewarp
