// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "problems/single_muscle/volume_term.h"

#include <cmath>

namespace musclewarp {

VolumeTerm::VolumeTerm(const MuscleUnknowns* unknowns,
                       VolumeEvaluator* evaluator,
                       const HardConstraint* constraint)
    : unknowns_(*unknowns), evaluator_(*evaluator), constraint_(*constraint) {
  set_num_residuals(1);
  mutable_parameter_block_sizes()->assign(evaluator->model().coarse_rest.rows(),
                                          3);
}

bool VolumeTerm::Evaluate(double const* const* parameters,
                          double* residual,
                          double** jacobians) const {
  const double area = evaluator_.model().rest_area;
  const Points& coarse = unknowns_.CoarseOf(parameters);
  residual[0] = constraint_.Residual(evaluator_.Error(coarse) / area);
  if (jacobians) {
    const double root = std::sqrt(constraint_.penalty);
    const Points gradient = unknowns_.GradientOf(evaluator_.Gradient(coarse));
    for (Eigen::Index j = 0; j < gradient.rows(); ++j) {
      if (!jacobians[j]) continue;
      Eigen::Map<Eigen::RowVector3d> block(jacobians[j]);
      block = root / area * gradient.row(j);
    }
  }
  return std::isfinite(residual[0]);
}

}  // namespace musclewarp
