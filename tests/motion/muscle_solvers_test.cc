// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/muscle_solvers.h"

#include <gtest/gtest.h>
#include <omp.h>

#include "support/prepared_small_scene.h"

namespace musclewarp {
namespace {

TEST(SolveEachOnItsOwn, DoesNotDependOnTheNumberOfThreads) {
  const PreparedScene scene = PreparedSmallScene();
  std::vector<const MuscleModel*> models;
  std::vector<MuscleTarget> targets;
  std::vector<MuscleState> start;
  for (const PreparedMuscle& muscle : scene.muscles) {
    models.push_back(&muscle.model);
    targets.push_back(TargetOf(muscle.model, FlexedPose(0.2), {}));
    start.push_back({muscle.model.coarse_rest, {}});
  }
  const int threads = omp_get_max_threads();
  std::vector<std::vector<MuscleState>> results;
  for (const int count : {1, 3}) {
    omp_set_num_threads(count);
    std::vector<MuscleState> states = start;
    std::vector<SolverSummary> summaries;
    SolveEachOnItsOwn(
        ReferenceSolvers().single, models, targets, &states, &summaries);
    ASSERT_EQ(summaries.size(), 2u);
    for (const SolverSummary& summary : summaries) {
      EXPECT_TRUE(summary.IsSolutionUsable());
    }
    results.push_back(states);
  }
  omp_set_num_threads(threads);
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(results[0][i].coarse, results[1][i].coarse);
    EXPECT_GT((results[0][i].coarse - start[i].coarse).norm(), 1);
  }
}

}  // namespace
}  // namespace musclewarp
