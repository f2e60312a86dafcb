// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Reads a PLY file, ASCII or binary of either byte order. `bytes` is the whole
// file, `path` is used in messages only; see mesh_io.h for what all readers
// promise and throw. The points are the properties x, y, z of the element
// "vertex", the faces the list vertex_indices (or vertex_index) of the element
// "face", and the strips of triangles that of "tristrips"; all other properties
// and elements are skipped.
//
// This reader, like those of the other formats, exists because the ready-made
// ones are not strict enough: those of CGAL 5.5 allocate whatever the header
// promises and do not say where a file is damaged, those of OpenMesh round
// coordinates to float and drop non-manifold faces.
TriangleSoup ReadPly(const std::string& path, std::string_view bytes);

// Returns the bytes of a PLY file: binary, little endian, double precision.
std::string PlyBytes(const TriangleSoup& soup);

}  // namespace musclewarp
