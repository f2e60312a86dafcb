// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/frame_solvers/rest_separation.h"
#include "musclewarp/initial_separation/medial_cell.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/preparation/prepared_scene.h"

namespace musclewarp {

// Reconstructs the surfaces of muscles from their medial cells (cell_surface.h)
// among the meshes of the scene, one per index in `muscles`. `attempt` counts
// from 0; the margin grows with it. The surface of an empty cell has no
// triangles. Precondition: the options are valid.
std::vector<TriangleSoup> ReconstructedSurfaces(
    const ReconstructionOptions& options,
    const MedialCellOptions& cell,
    const std::vector<int>& muscles,
    int attempt,
    const PreparedScene& scene);

}  // namespace musclewarp
