// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/mesh_files/mesh_parts.h"
#include "musclewarp/mesh_repair/repair.h"

namespace musclewarp {

// Throws InputError if a file holds several named parts, such as the objects of
// an .obj, and the repair of a muscle, which is one closed surface, has left
// out a whole one: the names, and how to name one. Parts that together are one
// surface, such as its materials, lose nothing. `path` is that of the muscle,
// `delivered` its mesh before repair.
void CheckNoPartIsLost(const std::string& path,
                       const MeshParts& parts,
                       const TriangleSoup& delivered,
                       const TriangleSoup& repaired,
                       const RepairReport& repairs);

}  // namespace musclewarp
