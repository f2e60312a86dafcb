// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/volume_constraint.h"

#include "musclewarp/mesh/measures.h"
#include "musclewarp/solver/volume_evaluator.h"

namespace musclewarp {
FineVolume EvaluateFineVolume(const MuscleModel& model,
                              const Points& coarse,
                              const VertexCorrections& corrections) {
  VolumeEvaluator evaluator(model, &corrections);
  const double error = evaluator.Error(coarse);
  return {error, evaluator.Gradient(coarse)};
}

double FineVolumeError(const MuscleModel& model,
                       const Points& coarse,
                       const VertexCorrections& corrections) {
  return VolumeEvaluator(model, &corrections).Error(coarse);
}

FineVolume EvaluateCoarseVolume(const MuscleModel& model,
                                const Points& coarse,
                                const VertexCorrections& corrections) {
  VolumeEvaluator evaluator(model, &corrections);
  evaluator.SetMesh(VolumeMesh::kCoarse);
  const double error = evaluator.Error(coarse);
  return {error,
          model.coarse_rest_volume / model.rest_volume *
              evaluator.Gradient(coarse)};
}

void SummarizeSolution(const MuscleModel& model,
                       const MuscleTarget& target,
                       const MuscleState& state,
                       SolverSummary* summary) {
  summary->final_energy = LinearEnergy(model, target, state.coarse);
  summary->volume_ratio =
      SignedVolume(FinePoints(model, state), model.fine_triangles) /
      model.rest_volume;
}

}  // namespace musclewarp
