// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// XML polydata (.vtp, "VTK File Formats"), see mesh_io.h. Polygons and triangle
// strips of all pieces are the faces; vertices, lines and data on points and
// cells are skipped. `path` is for messages, `bytes` is the whole file.
// VTK only unpacks the blocks: its reader (9.1) believes cell offsets, counts
// and block sizes and writes beyond its buffers when they are damaged, and it
// does not renumber the corners of a piece that is the first to have cells.
TriangleSoup ReadVtp(const std::string& path, std::string_view bytes);

}  // namespace musclewarp
