// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/base/progress.h"
#include "musclewarp/frame_solvers/rest_result.h"
#include "musclewarp/frame_solvers/rest_separation.h"
#include "musclewarp/motion/muscle_solvers.h"
#include "musclewarp/preparation/prepared_scene.h"

namespace musclewarp {

// Removes the triangles that the separation of the rest pose has drawn out
// (drawn_out_triangles.h) from the meshes of the scene, and relaxes the rest
// pose again from where it is. Such triangles are small: the sides of creases
// that contact opens, and needles of the segmentation. What would make meshes
// cross, or displace a muscle beyond the requirements, is left out.
// Preconditions: nothing crosses in `rest`, and the options are valid.
void RetriangulateDrawnOut(const RestSeparationOptions& options,
                           const MuscleSolver& solver,
                           const ProgressCallback& on_progress,
                           PreparedScene* scene,
                           RestResult* rest);

}  // namespace musclewarp
