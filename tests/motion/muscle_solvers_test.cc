// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/muscle_solvers.h"

#include <gtest/gtest.h>

#include <limits>

#include "musclewarp/base/threads.h"
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
  const int threads = NumThreads();
  std::vector<std::vector<MuscleState>> results;
  for (const int count : {1, 3}) {
    SetNumThreads(count);
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
  SetNumThreads(threads);
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(results[0][i].coarse, results[1][i].coarse);
    EXPECT_GT((results[0][i].coarse - start[i].coarse).norm(), 1);
  }
}

TEST(SolveEachOnItsOwn, AMuscleThatIsNotFiniteStaysWhereItWas) {
  const PreparedScene scene = PreparedSmallScene();
  std::vector<const MuscleModel*> models;
  std::vector<MuscleTarget> targets;
  std::vector<MuscleState> states;
  for (const PreparedMuscle& muscle : scene.muscles) {
    models.push_back(&muscle.model);
    targets.push_back(TargetOf(muscle.model, FlexedPose(0.2), {}));
    states.push_back({muscle.model.coarse_rest, {}});
  }
  const MuscleSolver breaks_first = [&](const MuscleModel& model,
                                        const MuscleTarget& target,
                                        Points* coarse,
                                        SolverSummary* summary) {
    ReferenceSolvers().single(model, target, coarse, summary);
    if (&model != models[0]) return;
    (*coarse)(3, 1) = std::numeric_limits<double>::quiet_NaN();
  };
  std::vector<SolverSummary> summaries;
  SolveEachOnItsOwn(breaks_first, models, targets, &states, &summaries);
  EXPECT_EQ(states[0].coarse, models[0]->coarse_rest);
  EXPECT_FALSE(summaries[0].IsSolutionUsable());
  EXPECT_NE(summaries[0].message.find("not finite"), std::string::npos);
  EXPECT_TRUE(summaries[1].IsSolutionUsable());
  EXPECT_GT((states[1].coarse - models[1]->coarse_rest).norm(), 1);
}

TEST(KeepFinite, AStartThatIsNotFiniteEitherLeavesTheRestPose) {
  const PreparedScene scene = PreparedSmallScene();
  const MuscleModel& model = scene.muscles[0].model;
  MuscleState broken = {model.coarse_rest, {}};
  broken.coarse(0, 0) = std::numeric_limits<double>::infinity();
  MuscleState state = broken;
  SolverSummary summary = NothingToSolve();
  KeepFinite(model, broken, &state, &summary);
  EXPECT_EQ(state.coarse, model.coarse_rest);
  EXPECT_EQ(summary.stop_reason, StopReason::kFailed);
}

}  // namespace
}  // namespace musclewarp
