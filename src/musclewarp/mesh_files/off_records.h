// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "musclewarp/mesh_files/text_cursor.h"

namespace musclewarp {

// The header of an OFF file: a keyword, which says what stands behind the
// coordinates of a vertex, and the numbers of vertices and faces.
struct OffHeader {
  std::int64_t vertices = 0;
  std::int64_t faces = 0;
  bool is_binary = false;
  bool has_normals = false;   // N: 3 numbers
  bool has_colours = false;   // C: 3 or 4 numbers, in binary files 4
  bool has_textures = false;  // ST: 2 numbers
};

// How many numbers a vertex has, with 3 or 4 for its colour.
std::int64_t NumbersOfVertex(const OffHeader& header, int of_colour);

// Reads the keyword, and the counts of a text file. Throws InputError for files
// that start with another word, and for vertices of another dimension (4OFF,
// nOFF).
OffHeader ReadOffHeader(const std::string& path, TextCursor* cursor);

// How the records of a text file, its vertices and faces, lie on its lines.
enum class OffLayout {
  kLines,   // one a line; what a line has more is a colour
  kOver,    // some go on on the next line
  kStream,  // words without regard to lines, and no colours of faces
};

// Tells the layout from the number of lines behind the header, which the cursor
// has just read.
OffLayout LayoutOfOff(const OffHeader& header, TextCursor cursor);

}  // namespace musclewarp
