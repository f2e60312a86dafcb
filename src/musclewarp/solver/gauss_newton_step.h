// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/solver/muscle_model.h"
#include "musclewarp/solver/muscle_state.h"
#include "musclewarp/solver/one_sided_rows.h"

namespace musclewarp {

struct GaussNewtonStep {
  Points h;                 // N x 3, mm
  double volume_error = 0;  // g of the state the step is for, mm^3
  bool is_finite = false;   // false: the volume gradient vanished
};

// The step of paper eq. (2.8) to (2.10) in the reading of docs/method.md,
//
//   lambda = (J_g A^-1 J_g^T)^-1 (dV / alpha - J_g A^-1 J_f^T f)
//   h      = -A^-1 (J_f^T f + J_g^T lambda),
//
// so that J_g (alpha h) = -dV. `minimizer` is X*; dV is taken from the fine
// mesh, or from the coarse mesh and scaled. Held vertices have no rows in J_g.
// With `one_sided` A and f have the rows that are active at the state.
GaussNewtonStep StepFrom(const MuscleModel& model,
                         const Points& minimizer,
                         const MuscleState& state,
                         double alpha,
                         bool is_fine_volume,
                         OneSidedSystem* one_sided = nullptr);

}  // namespace musclewarp
