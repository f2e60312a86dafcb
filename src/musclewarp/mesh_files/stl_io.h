// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Reads an STL file, ASCII or binary. `bytes` is the whole file, `path` is used
// in messages only; see mesh_io.h for what all readers promise and throw. The
// format repeats the corners of every facet: corners with identical coordinates
// become one point, and points are in the order of their first mention. The
// normals in the file are skipped.
TriangleSoup ReadStl(const std::string& path, std::string_view bytes);

// Returns the bytes of a binary STL file. The coordinates are rounded to float;
// points that no triangle uses are lost. Precondition: coordinates fit the
// range of float (WriteTriangleSoup refuses others).
std::string StlBytes(const TriangleSoup& soup);

}  // namespace musclewarp
