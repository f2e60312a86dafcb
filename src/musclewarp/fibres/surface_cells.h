// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/fibres/voxel_grid.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Returns, for each cell of the grid, whether a triangle passes through it.
// Where the mesh is thinner than a voxel, these cells cover it and are
// connected over faces, even if none of their centres is inside. Precondition:
// the mesh lies within the grid.
std::vector<char> SurfaceCells(const TriangleSoup& mesh, const VoxelGrid& grid);

}  // namespace musclewarp
