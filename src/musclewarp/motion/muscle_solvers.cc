// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/muscle_solvers.h"

namespace musclewarp {

namespace {

bool IsFinite(const MuscleState& state) {
  return state.coarse.allFinite() && state.corrections.fine_offset.allFinite();
}

}  // namespace

void KeepFinite(const MuscleModel& model,
                const MuscleState& before,
                MuscleState* state,
                SolverSummary* summary) {
  if (IsFinite(*state)) return;
  *state = IsFinite(before) ? before : MuscleState{model.coarse_rest, {}};
  summary->stop_reason = StopReason::kFailed;
  summary->message =
      "coordinates that are not finite came up, and were thrown away";
}

void SolveEachOnItsOwn(const MuscleSolver& solver,
                       const std::vector<const MuscleModel*>& models,
                       const std::vector<MuscleTarget>& targets,
                       std::vector<MuscleState>* states,
                       std::vector<SolverSummary>* summaries) {
  summaries->resize(models.size());
  const int count = static_cast<int>(models.size());
#pragma omp parallel for schedule(dynamic)
  for (int i = 0; i < count; ++i) {
    if (!models[i]->HasLines()) {
      (*summaries)[i] = NothingToSolve();
      continue;
    }
    const MuscleState before = (*states)[i];
    solver(*models[i], targets[i], &(*states)[i].coarse, &(*summaries)[i]);
    KeepFinite(*models[i], before, &(*states)[i], &(*summaries)[i]);
  }
}

}  // namespace musclewarp
