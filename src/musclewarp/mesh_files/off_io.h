// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Reads an OFF file (the object file format of Geomview), ASCII or binary.
// `bytes` is the whole file, `path` is used in messages only; see mesh_io.h for
// what all readers promise and throw. Normals, colours and texture coordinates
// are skipped. A vertex or a face has a line of its own, goes on on the next
// one, or shares it with others (OffLayout).
TriangleSoup ReadOff(const std::string& path, std::string_view bytes);

// Returns the text of an OFF file. Coordinates have 17 digits, from which the
// same doubles are read again.
std::string OffBytes(const TriangleSoup& soup);

}  // namespace musclewarp
