// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "problems/single_muscle/one_sided_term.h"

namespace musclewarp {

OneSidedTerm::OneSidedTerm(const MuscleModel& model,
                           const OneSidedRows* rows,
                           const MuscleUnknowns* unknowns)
    : unknowns_(*unknowns),
      rows_(*rows),
      fine_from_coarse_(FineFromCoarse(model, *rows)),
      fine_from_unknowns_(unknowns->RowsOf(fine_from_coarse_)) {
  set_num_residuals(rows->size());
  mutable_parameter_block_sizes()->assign(model.coarse_rest.rows(), 3);
}

bool OneSidedTerm::Evaluate(double const* const* parameters,
                            double* residuals,
                            double** jacobians) const {
  const Points& coarse = unknowns_.CoarseOf(parameters);
  Eigen::Map<Eigen::VectorXd> depths(residuals, rows_.size());
  depths = OneSidedDepths(rows_, fine_from_coarse_, coarse);
  for (int j = 0; jacobians && j < unknowns_.num_blocks(); ++j) {
    if (!jacobians[j]) continue;
    Eigen::Map<Points> block(jacobians[j], rows_.size(), 3);
    for (int k = 0; k < rows_.size(); ++k) {
      const double weight =
          depths[k] > 0 ? -rows_.weight * fine_from_unknowns_(k, j) : 0;
      block.row(k) = weight * rows_.normals.row(k);
    }
  }
  depths = rows_.weight * depths.cwiseMax(0);
  return depths.allFinite();
}

}  // namespace musclewarp
