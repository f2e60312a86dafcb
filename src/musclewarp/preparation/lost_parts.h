// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/mesh_files/mesh_parts.h"
#include "musclewarp/mesh_repair/repair.h"

namespace musclewarp {

// Throws InputError if a file contains several named parts, such as the objects
// of an .obj, and the repair of a muscle, which is one closed surface, has left
// out a complete part. The message lists the names and explains how to select
// one. Parts that together form one surface, such as its materials, lose
// nothing. `path` is the file of the muscle, `delivered` its mesh before
// repair, `repaired` its mesh afterwards.
void CheckNoPartIsLost(const std::string& path,
                       const MeshParts& parts,
                       const TriangleSoup& delivered,
                       const TriangleSoup& repaired,
                       const RepairReport& repairs);

}  // namespace musclewarp
