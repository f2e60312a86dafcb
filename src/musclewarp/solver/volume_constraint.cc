// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/volume_constraint.h"

#include "musclewarp/geometry/dense_product.h"
#include "musclewarp/mesh/measures.h"

namespace musclewarp {

FineVolume EvaluateFineVolume(const MuscleModel& model, const Points& coarse) {
  const Points fine = Product(model.fine_from_coarse, coarse);
  const Points fine_gradient = VolumeGradient(fine, model.fine_triangles);
  FineVolume volume;
  volume.error = SignedVolume(fine, model.fine_triangles) - model.rest_volume;
  volume.gradient = TransposedProduct(model.fine_from_coarse, fine_gradient);
  return volume;
}

double FineVolumeError(const MuscleModel& model, const Points& coarse) {
  return SignedVolume(Product(model.fine_from_coarse, coarse),
                      model.fine_triangles) -
         model.rest_volume;
}

void SummarizeSolution(const MuscleModel& model,
                       const MuscleTarget& target,
                       const Points& coarse,
                       SolverSummary* summary) {
  summary->final_energy = LinearEnergy(model, target, coarse);
  summary->volume_ratio =
      1 + FineVolumeError(model, coarse) / model.rest_volume;
}

}  // namespace musclewarp
