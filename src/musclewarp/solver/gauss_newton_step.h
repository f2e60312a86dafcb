// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/solver/muscle_model.h"
#include "musclewarp/solver/muscle_state.h"
#include "musclewarp/solver/one_sided_rows.h"

namespace musclewarp {

// A step of the reference solver, to be applied as X <- X + alpha h.
struct GaussNewtonStep {
  // The full step, N x 3, mm.
  Points h;

  // The volume error g of the state that the step starts from, mm^3.
  double volume_error = 0;

  // False if the volume gradient vanished, in which case h must not be used.
  bool is_finite = false;
};

// Computes the step of paper eq. (2.8) to (2.10) in the reading of
// docs/method.md,
//
//   lambda = (J_g A^-1 J_g^T)^-1 (dV / alpha - J_g A^-1 J_f^T f)
//   h      = -A^-1 (J_f^T f + J_g^T lambda),
//
// which satisfies J_g (alpha h) = -dV: the shortened step, not the full one,
// corrects the volume to first order.
//
// `minimizer` (N x 3, mm) is X*, the minimiser of the linear energy
// (UnconstrainedMinimizer). Because f is linear, -A^-1 J_f^T f = X* - X, and no
// row of f has to be evaluated. If `is_fine_volume`, dV is the volume error of
// the fine mesh; else it is that of the coarse mesh, scaled to the fine one.
// Held vertices of the state have zero rows in J_g (paper section 3.3).
//
// If `one_sided` is given, A and f include its rows that are active at the
// state; their choice is updated by this call.
// Precondition: alpha is above 0.
GaussNewtonStep ComputeGaussNewtonStep(const MuscleModel& model,
                                       const Points& minimizer,
                                       const MuscleState& state,
                                       double alpha,
                                       bool is_fine_volume,
                                       OneSidedSystem* one_sided = nullptr);

}  // namespace musclewarp
