// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/group_solver.h"

#include <glog/logging.h>

#include <utility>

namespace musclewarp {

GroupSolver EachOnItsOwn(MuscleSolver solver) {
  return [solver = std::move(solver)](
             const std::vector<const MuscleModel*>& models,
             const std::vector<MuscleTarget>& targets,
             GroupContact* contact,
             std::vector<MuscleState>* states,
             std::vector<SolverSummary>* summaries) {
    CHECK(contact == nullptr);
    summaries->resize(models.size());
    const int count = static_cast<int>(models.size());
#pragma omp parallel for schedule(dynamic)
    for (int i = 0; i < count; ++i) {
      solver(*models[i], targets[i], &(*states)[i].coarse, &(*summaries)[i]);
    }
  };
}

}  // namespace musclewarp
