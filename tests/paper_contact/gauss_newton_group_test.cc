// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/paper_contact/gauss_newton_group.h"

#include <gtest/gtest.h>

#include "musclewarp/base/threads.h"
#include "support/muscle_groups.h"

namespace musclewarp {
namespace {

class GaussNewtonGroup : public ::testing::TestWithParam<ContactLevel> {};

TEST_P(GaussNewtonGroup, PartsMusclesAndKeepsTheirVolume) {
  TouchingSpindles scene(GetParam());
  GroupContact contact = scene.Contact();
  std::vector<MuscleState> states = scene.RestStates();
  ASSERT_GT(scene.VerticesInside(states), 0);
  std::vector<SolverSummary> summaries;
  SolveGaussNewtonGroup(
      scene.Models(), scene.Targets(), {}, &contact, &states, &summaries);
  EXPECT_EQ(scene.VerticesInside(states), 0);
  for (size_t i = 0; i < states.size(); ++i) {
    EXPECT_EQ(summaries[i].stop_reason, StopReason::kConverged);
    EXPECT_NEAR(summaries[i].volume_ratio, 1, 1e-9);
    EXPECT_EQ(summaries[i].history.size(),
              static_cast<size_t>(summaries[i].iterations));
  }
}

TEST_P(GaussNewtonGroup, SaysThatItStopped) {
  TouchingSpindles scene(GetParam());
  GroupContact contact = scene.Contact();
  std::vector<MuscleState> states = scene.RestStates();
  GroupIterationOptions options;
  options.max_iterations = 3;
  std::vector<SolverSummary> summaries;
  SolveGaussNewtonGroup(
      scene.Models(), scene.Targets(), options, &contact, &states, &summaries);
  EXPECT_EQ(summaries[0].stop_reason, StopReason::kIterationLimit);
  EXPECT_EQ(summaries[0].iterations, 3);
}

TEST_P(GaussNewtonGroup, ApartIsWhatItIsWithoutContact) {
  TouchingSpindles scene(GetParam(), /*gap=*/50);
  GroupContact contact = scene.Contact();
  std::vector<MuscleState> states = scene.RestStates();
  std::vector<SolverSummary> summaries;
  // From the rest pose, which is the solution.
  SolveGaussNewtonGroup(
      scene.Models(), scene.Targets(), {}, &contact, &states, &summaries);
  for (size_t i = 0; i < states.size(); ++i) {
    EXPECT_LT((states[i].coarse - scene.models[i].coarse_rest).norm(), 1e-8);
  }
}

TEST_P(GaussNewtonGroup, IsTheSameToTheBitForEveryNumberOfThreads) {
  TouchingSpindles scene(GetParam());
  GroupIterationOptions options;
  options.max_iterations = 20;
  const int threads = NumThreads();
  std::vector<std::vector<MuscleState>> results;
  for (const int count : {1, 4}) {
    SetNumThreads(count);
    GroupContact contact = scene.Contact();
    results.push_back(scene.RestStates());
    std::vector<SolverSummary> summaries;
    SolveGaussNewtonGroup(scene.Models(),
                          scene.Targets(),
                          options,
                          &contact,
                          &results.back(),
                          &summaries);
  }
  SetNumThreads(threads);
  for (size_t i = 0; i < scene.models.size(); ++i) {
    EXPECT_EQ(results[0][i].coarse, results[1][i].coarse);
    EXPECT_EQ(results[0][i].corrections.fine_offset,
              results[1][i].corrections.fine_offset);
  }
}

INSTANTIATE_TEST_SUITE_P(Levels,
                         GaussNewtonGroup,
                         ::testing::Values(ContactLevel::kCoarse,
                                           ContactLevel::kFine));

}  // namespace
}  // namespace musclewarp
