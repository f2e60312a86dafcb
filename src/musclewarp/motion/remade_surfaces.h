// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/certified_contact/medial_cell.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/motion/prepared_scene.h"
#include "musclewarp/motion/rest_remaking.h"

namespace musclewarp {

// Makes the surfaces of muscles anew from their medial cells (cell_surface.h),
// one for each number in `muscles`, from the meshes of the scene. A muscle of
// which the others and the bones would leave too little
// (RestRemakingOptions::least_share_as_delivered) is made from the meshes at
// `separated` (#V x 3 each, mm, in scene order), where contact has moved them
// in the rest pose: these hardly overlap, and have their volumes. `attempt`
// counts from 0: later surfaces keep larger margins. A surface has no triangles
// if nothing is left. Precondition: the options are valid.
std::vector<TriangleSoup> RemadeSurfaces(const RestRemakingOptions& options,
                                         const MedialCellOptions& cell,
                                         const std::vector<int>& muscles,
                                         int attempt,
                                         const PreparedScene& scene,
                                         const std::vector<Points>& separated);

}  // namespace musclewarp
