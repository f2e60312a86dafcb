// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/mesh_files/mesh_parts.h"

namespace musclewarp {

// Reads an STL file, ASCII or binary. `bytes` is the whole file, `path` is used
// in messages only; see mesh_io.h for what all readers promise and throw. The
// format repeats the corners of every facet: corners with identical coordinates
// become one point, and points are in the order of their first mention. The
// normals in the file are skipped. A binary file may have more bytes than its
// facets take, which a note tells. `parts`, unless null, is set to the solids
// of an ASCII file; the third is called "solid_3" if it has no name.
TriangleSoup ReadStl(const std::string& path,
                     std::string_view bytes,
                     std::vector<std::string>* notes = nullptr,
                     MeshParts* parts = nullptr);

// Returns the bytes of a binary STL file. The coordinates are rounded to float;
// points that no triangle uses are lost. Precondition: coordinates fit the
// range of float (WriteTriangleSoup refuses others).
std::string StlBytes(const TriangleSoup& soup);

}  // namespace musclewarp
