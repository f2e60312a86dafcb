// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "problems/single_muscle/volume_term.h"

#include <cmath>

#include "musclewarp/solver/volume_constraint.h"

namespace musclewarp {

VolumeTerm::VolumeTerm(const MuscleModel* model,
                       const HardConstraint* constraint,
                       const Whitening* whitening)
    : model_(*model), constraint_(*constraint), whitening_(whitening) {
  set_num_residuals(1);
  mutable_parameter_block_sizes()->assign(model->coarse_rest.rows(), 3);
}

bool VolumeTerm::Evaluate(double const* const* parameters,
                          double* residual,
                          double** jacobians) const {
  Points unknowns(model_.coarse_rest.rows(), 3);
  for (Eigen::Index j = 0; j < unknowns.rows(); ++j) {
    unknowns.row(j) = Eigen::Map<const Eigen::RowVector3d>(parameters[j]);
  }
  const Points coarse =
      whitening_ ? whitening_->CoarseFromWhitened(unknowns) : unknowns;
  const double root = std::sqrt(constraint_.penalty);
  const double shift = constraint_.multiplier / constraint_.penalty;
  if (!jacobians) {
    const double error = FineVolumeError(model_, coarse);
    residual[0] = root * (error / model_.rest_area + shift);
    return std::isfinite(residual[0]);
  }

  const FineVolume volume = EvaluateFineVolume(model_, coarse);
  residual[0] = root * (volume.error / model_.rest_area + shift);
  const Points gradient = whitening_
                              ? whitening_->WhitenedGradient(volume.gradient)
                              : volume.gradient;
  for (Eigen::Index j = 0; j < gradient.rows(); ++j) {
    if (!jacobians[j]) continue;
    Eigen::Map<Eigen::RowVector3d> block(jacobians[j]);
    block = root / model_.rest_area * gradient.row(j);
  }
  return std::isfinite(residual[0]);
}

}  // namespace musclewarp
