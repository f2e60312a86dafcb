// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/solver/muscle_model.h"
#include "musclewarp/solver/muscle_state.h"

namespace musclewarp {

// Brings the volume of the fine mesh back to that at rest with the least change
// of shape, min 1/2 |J_f dX|^2, by Newton steps along A^-1 J_g^T; held vertices
// stay where they are (on the fine mesh by their offset). For small errors:
// gives up after a few steps, without harm. Returns the relative volume error
// that is left.
double RestoreVolume(const MuscleModel& model, MuscleState* state);

}  // namespace musclewarp
