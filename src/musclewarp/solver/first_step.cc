// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/first_step.h"

#include "musclewarp/solver/one_sided_rows.h"

namespace musclewarp {

FirstStep FirstStepFrom(const MuscleModel& model,
                        const MuscleTarget& target,
                        const Points& coarse,
                        VolumeEvaluator* volume) {
  const double error = volume->Error(coarse);
  const Points& gradient = volume->Gradient(coarse);
  Points descent = LinearDescent(model, target, coarse);
  const OneSidedRows& rows = target.one_sided;
  if (rows.size() > 0) {
    const RowMajorMatrix fine_from_coarse = FineFromCoarse(model, rows);
    descent += OneSidedDescent(
        rows, fine_from_coarse, OneSidedDepths(rows, fine_from_coarse, coarse));
  }
  const Points inverse_gradient = model.normal_matrix.solve(gradient);
  const double norm = gradient.cwiseProduct(inverse_gradient).sum();
  FirstStep first;
  if (norm > 0) {
    first.multiplier = inverse_gradient.cwiseProduct(descent).sum() / norm;
  }
  const double share = norm > 0 ? first.multiplier + error / norm : 0;
  const Points step =
      model.normal_matrix.solve(descent) - share * inverse_gradient;
  first.length = step.rowwise().norm().maxCoeff();
  return first;
}

}  // namespace musclewarp
