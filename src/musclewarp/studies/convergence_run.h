// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/deformer/deformer.h"
#include "musclewarp/preparation/prepared_scene.h"
#include "musclewarp/studies/convergence_study.h"

namespace musclewarp {

// Returns the discretisation that options set, with the meshes as prepared.
Discretisation DiscretisationOf(const PrepareOptions& options);

// Returns a prepared scene with another discretisation. `base` has the one that
// the options set. Another number of coarse vertices gives new hulls; other
// samples and densities keep the hulls of `base`. Throws InputError if the
// lines no longer determine a shape.
PreparedScene Rediscretised(const PreparedScene& base,
                            const PrepareOptions& options,
                            const Discretisation& discretisation);

// Solves frames of a scene, given by the indices of their poses in rising
// order, with one discretisation. Without contact every frame is solved on its
// own. With certified contact the scene is separated at rest first, and the
// frames of a motion are solved in order from its start, those that are not
// wanted, too. What throws InputError on the way is the failure of the result.
// Preconditions: the options are valid, their contact is none or certified
// (CHECKed), and `base` was prepared with them.
DiscretisationResult SolveDiscretisation(const DeformerOptions& options,
                                         const PreparedScene& base,
                                         const Discretisation& discretisation,
                                         const std::vector<int>& frames);

}  // namespace musclewarp
