// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/certificate/scene_intersections.h"
#include "musclewarp/mesh/box.h"

namespace musclewarp {

// Throws InputError, naming the mesh, if a lattice of `spacing` mm over a box
// has more than 3e8 points, which take 2.4 GB of memory.
void CheckLatticeFits(const std::string& name, const Box3& box, double spacing);

// Returns true if CheckLatticeFits accepts such a lattice.
bool LatticeFits(const Box3& box, double spacing);

// Throws InputError, naming the mesh, if the lattice of medial cells, with
// voxels of `voxel_size` mm, does not fit (CheckLatticeFits), or if the
// triangles of a muscle are so small that more than 1e9 pairs lie within
// `reach` mm of each other.
void CheckContactFits(const std::vector<NamedMesh>& muscles,
                      double voxel_size,
                      double reach);

}  // namespace musclewarp
