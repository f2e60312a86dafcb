// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/gauss_newton_step.h"

#include <utility>

#include "musclewarp/solver/volume_constraint.h"

namespace musclewarp {

GaussNewtonStep ComputeGaussNewtonStep(const MuscleModel& model,
                                       const Points& minimizer,
                                       const MuscleState& state,
                                       double alpha,
                                       bool is_fine_volume,
                                       OneSidedSystem* one_sided) {
  const FineVolume volume =
      is_fine_volume
          ? EvaluateFineVolume(model, state.coarse, state.corrections)
          : EvaluateCoarseVolume(model, state.coarse, state.corrections);
  // -A^-1 J_f^T f = X* - X, because f is linear.
  Points to_minimizer = minimizer - state.coarse;
  Points inverse_gradient = model.normal_matrix.solve(volume.gradient);
  if (one_sided) {
    one_sided->UpdateActiveRows(state.coarse);
    to_minimizer = one_sided->CorrectedStep(to_minimizer);
    inverse_gradient =
        one_sided->CorrectedSolution(std::move(inverse_gradient));
  }
  const double denominator =
      volume.gradient.cwiseProduct(inverse_gradient).sum();
  const double lambda = (volume.error / alpha +
                         volume.gradient.cwiseProduct(to_minimizer).sum()) /
                        denominator;
  GaussNewtonStep step;
  step.h = to_minimizer - lambda * inverse_gradient;
  step.volume_error = volume.error;
  step.is_finite = denominator > 0 && step.h.allFinite();
  return step;
}

}  // namespace musclewarp
