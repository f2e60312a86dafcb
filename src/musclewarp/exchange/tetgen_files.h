// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/exchange/tetrahedral_mesh.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// The file that TetGen is given.
constexpr char kTetgenSurface[] = "surface.smesh";

// Writes a surface for TetGen to a folder, to the last bit. Throws InputError
// if it cannot be written.
void WriteTetgenInput(const std::string& dir, const TriangleSoup& surface);

// Reads what TetGen made of it (surface.1.node, surface.1.ele). The points of
// the mesh begin with those of the surface, rounded to 16 digits. Tetrahedra
// are as TetGen has them, in either orientation. Throws InputError if a file is
// missing or damaged.
TetrahedralMesh ReadTetgenResult(const std::string& dir);

}  // namespace musclewarp
