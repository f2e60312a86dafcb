// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// STL, see mesh_io.h. `path` is for messages, `bytes` is the whole file.
// Corners with identical coordinates become one point, in the order of first
// mention; the normals in the file are skipped.
TriangleSoup ReadStl(const std::string& path, std::string_view bytes);

// Binary: coordinates are rounded to float, whose range they must fit.
std::string StlBytes(const TriangleSoup& soup);

}  // namespace musclewarp
