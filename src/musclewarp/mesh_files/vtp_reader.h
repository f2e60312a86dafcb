// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Reads XML polydata (.vtp, "VTK File Formats"), with arrays as text, as base64
// or appended, compressed or not. `bytes` is the whole file, `path` is used in
// messages only; see mesh_io.h for what all readers promise and throw. Polygons
// and triangle strips of all pieces become the triangles; vertices, lines, and
// data on points and cells are skipped. Only in builds with
// MUSCLEWARP_WITH_VTK.
//
// VTK serves only to decompress blocks. Its own reader (9.1) believes cell
// offsets, counts and block sizes and writes beyond its buffers when they are
// damaged, and it does not renumber the corners of a piece that is the first to
// have cells but not the first to have points.
TriangleSoup ReadVtp(const std::string& path, std::string_view bytes);

}  // namespace musclewarp
