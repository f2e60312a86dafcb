// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/deformer/deformer.h"
#include "musclewarp/preparation/prepared_scene.h"
#include "musclewarp/studies/convergence_study.h"

namespace musclewarp {

// Returns the discretisation that the options set, with a density of 1.
Discretisation DiscretisationOf(const PrepareOptions& options);

// Returns a prepared scene with another discretisation than that of `base`,
// which the options set. A different number of coarse vertices leads to new
// hulls; for other sample spacings and densities, the hulls of `base` are kept.
// Throws InputError if the lines no longer determine a shape.
PreparedScene Rediscretised(const PreparedScene& base,
                            const PrepareOptions& options,
                            const Discretisation& discretisation);

// Solves frames of a scene, given by the indices of their poses in ascending
// order, with one discretisation. Without contact every frame is solved on its
// own. With certified contact the scene is separated at rest first, and all
// frames of a motion up to the last requested one are solved in order. An
// InputError on the way becomes the failure of the result. Preconditions: the
// options are valid, their contact is none or certified (CHECKed), and `base`
// was prepared with them.
DiscretisationResult SolveDiscretisation(const DeformerOptions& options,
                                         const PreparedScene& base,
                                         const Discretisation& discretisation,
                                         const std::vector<int>& frames);

}  // namespace musclewarp
