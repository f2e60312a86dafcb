// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// PLY, see mesh_io.h. `path` is for messages, `bytes` is the whole file. The
// points are the properties x, y, z of the element "vertex", the faces the list
// vertex_indices (or vertex_index) of the element "face"; all else is skipped.
// A strict reader of our own, as for the other formats: the readers of CGAL 5.5
// allocate what the header promises and do not say where a file is damaged,
// those of OpenMesh round to float and drop non-manifold faces.
TriangleSoup ReadPly(const std::string& path, std::string_view bytes);

// Binary little endian, double.
std::string PlyBytes(const TriangleSoup& soup);

}  // namespace musclewarp
