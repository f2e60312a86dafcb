// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// OFF of Geomview, see mesh_io.h. `path` is for messages, `bytes` is the whole
// file. One vertex and one face a line, what follows on the line (normals,
// colours, texture coordinates) is skipped.
TriangleSoup ReadOff(const std::string& path, std::string_view bytes);

// 17 digits.
std::string OffBytes(const TriangleSoup& soup);

}  // namespace musclewarp
