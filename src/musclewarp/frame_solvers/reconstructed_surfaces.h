// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/frame_solvers/rest_separation.h"
#include "musclewarp/initial_separation/medial_cell.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/preparation/prepared_scene.h"

namespace musclewarp {

// Makes the surfaces of muscles anew from their medial cells (cell_surface.h),
// one for each number in `muscles`, from the meshes of the scene. `attempt`
// counts from 0: later surfaces keep larger margins. A surface has no triangles
// if nothing is left. Precondition (CHECKed): the options are valid.
std::vector<TriangleSoup> ReconstructedSurfaces(
    const ReconstructionOptions& options,
    const MedialCellOptions& cell,
    const std::vector<int>& muscles,
    int attempt,
    const PreparedScene& scene);

}  // namespace musclewarp
