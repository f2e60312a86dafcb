// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Wavefront OBJ, see mesh_io.h. `path` is for messages, `bytes` is the whole
// file. Statements other than v and f are skipped, unknown ones refused. The
// format holds no counts: a file cut between two faces cannot be told from a
// whole one.
TriangleSoup ReadObj(const std::string& path, std::string_view bytes);

// v and f, 17 digits.
std::string ObjBytes(const TriangleSoup& soup);

}  // namespace musclewarp
