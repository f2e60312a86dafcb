// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Reads polydata in the legacy format of VTK ("VTK File Formats", versions 1 to
// 5, ASCII and binary). `bytes` is the whole file, `path` is used in messages
// only; see mesh_io.h for what all readers promise and throw. Polygons and
// triangle strips become the triangles. Vertices, lines, metadata and field
// data of any type are skipped, and what follows the geometry (CELL_DATA,
// POINT_DATA) is not read.
//
// The reader does not use VTK, whose own reader (9.1) reads beyond its buffers
// when a file is truncated or a cell count is damaged.
TriangleSoup ReadLegacyVtk(const std::string& path, std::string_view bytes);

// Returns the bytes of a file that every VTK reads: version 3.0, binary, double
// precision.
std::string LegacyVtkBytes(const TriangleSoup& soup);

}  // namespace musclewarp
