// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/solver/muscle_model.h"
#include "musclewarp/solver/muscle_state.h"

namespace musclewarp {

// Restores the volume of the fine mesh to that at rest with the least change of
// shape, min 1/2 |J_f dX|^2 subject to g(X + dX) = 0. It takes Newton steps
// along A^-1 J_g^T until the relative error is below 1e-10. Held vertices stay
// where they are held: for fine ones, the offset is set so that
// W X + offset is the position at which they are held.
//
// Meant for small errors, such as those left after single vertices were moved.
// It gives up after five steps, and leaves X as it is if the gradient vanishes,
// as it does if all vertices are held.
//
// Returns the relative volume error V(W X + offset) / V_hat - 1 as it was last
// evaluated; after five steps, that of the state before the last one.
double RestoreVolume(const MuscleModel& model, MuscleState* state);

}  // namespace musclewarp
