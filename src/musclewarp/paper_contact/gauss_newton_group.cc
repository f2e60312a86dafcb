// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/paper_contact/gauss_newton_group.h"

#include <vector>

#include "musclewarp/solver/gauss_newton_step.h"

namespace musclewarp {

void SolveGaussNewtonGroup(const std::vector<const MuscleModel*>& models,
                           const std::vector<MuscleTarget>& targets,
                           const GroupIterationOptions& options,
                           GroupContact* contact,
                           std::vector<MuscleState>* states,
                           std::vector<SolverSummary>* summaries) {
  GroupProgress progress(
      models, targets, *states, options, *contact, summaries);
  const int count = static_cast<int>(models.size());
  std::vector<Points> minimizers;
  for (int i = 0; i < count; ++i) {
    minimizers.push_back(UnconstrainedMinimizer(*models[i], targets[i]));
  }

  contact->Start(states);
  std::vector<GaussNewtonStep> steps(count);
  std::vector<double> volume_errors(count);
  while (!progress.IsOver()) {
    const double alpha = progress.alpha();
#pragma omp parallel for schedule(dynamic)
    for (int i = 0; i < count; ++i) {
      steps[i] = ComputeGaussNewtonStep(*models[i],
                                        minimizers[i],
                                        (*states)[i],
                                        progress.volume_alpha(),
                                        progress.is_fine_volume());
      if (steps[i].is_finite) (*states)[i].coarse += alpha * steps[i].h;
    }
    for (int i = 0; i < count; ++i) {
      volume_errors[i] = steps[i].volume_error / models[i]->rest_volume;
      if (!steps[i].is_finite) progress.Fail(i, "the volume gradient vanished");
    }
    contact->AfterStep(alpha, states);
    progress.Record(*contact, volume_errors);
  }
  contact->Finish(states);
  progress.Finish(*states);
}

}  // namespace musclewarp
