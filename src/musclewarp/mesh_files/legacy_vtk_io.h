// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Polydata in the legacy format of VTK ("VTK File Formats", versions 1 to 5),
// see mesh_io.h. `path` is for messages, `bytes` is the whole file. Polygons
// and triangle strips are the faces; vertices and lines are skipped, and what
// follows the geometry (CELL_DATA, POINT_DATA) is not read.
// Needs no VTK, whose own reader (9.1) reads beyond its buffers when the file
// is truncated or a cell count damaged.
TriangleSoup ReadLegacyVtk(const std::string& path, std::string_view bytes);

// Binary, double, version 3.0, which every VTK reads.
std::string LegacyVtkBytes(const TriangleSoup& soup);

}  // namespace musclewarp
