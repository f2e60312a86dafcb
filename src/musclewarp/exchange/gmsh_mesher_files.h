// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/exchange/tetrahedral_mesh.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// The file that Gmsh is given, and the one that it writes.
constexpr char kGmshScript[] = "volume.geo";
constexpr char kGmshResult[] = "result.msh";

// Writes a surface for Gmsh to a folder, to the last bit, and the script by
// which Gmsh fills it: each closed piece is a volume of its own. Throws
// InputError if they cannot be written.
void WriteGmshInput(const std::string& dir, const TriangleSoup& surface);

// Reads what Gmsh made of it. The points of the mesh begin with those of the
// surface, rounded to 16 digits. Tetrahedra are as Gmsh has them, in either
// orientation. Throws InputError if the file is missing or damaged.
TetrahedralMesh ReadGmshResult(const std::string& dir);

}  // namespace musclewarp
