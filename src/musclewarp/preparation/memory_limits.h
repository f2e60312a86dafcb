// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/certificate/scene_intersections.h"
#include "musclewarp/mesh/box.h"

namespace musclewarp {

// Throws InputError, naming the mesh, if a lattice of `spacing` mm over a box
// would take more memory than machines have: 3e8 points, which are 2.4 GB.
void CheckLatticeFits(const std::string& name, const Box3& box, double spacing);

// Throws InputError, naming the mesh, if the triangles of a muscle are so small
// that contact would have to look at more than 1e9 pairs of them: each at all
// that are within `reach` mm. `voxel_size` (mm) is that of medial cells.
void CheckContactFits(const std::vector<NamedMesh>& muscles,
                      double voxel_size,
                      double reach);

}  // namespace musclewarp
