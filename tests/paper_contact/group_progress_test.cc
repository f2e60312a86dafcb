// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/paper_contact/group_progress.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/invalid_options.h"
#include "support/muscle_groups.h"

namespace musclewarp {
namespace {

// Two muscles far from each other, so that contact changes nothing, and the
// progress of a solver that does what the tests say.
class GroupProgressTest : public ::testing::Test {
 protected:
  GroupProgressTest() { contact_.Start(&states_); }

  // Moves the first muscle along x and records the iteration.
  void Iterate(GroupProgress* progress, double move, double volume_error) {
    states_[0].coarse.col(0).array() += move;
    contact_.AfterStep(progress->alpha(), &states_);
    progress->Record(contact_, {volume_error, 0});
  }

  GroupProgress Progress(const GroupIterationOptions& options) {
    return GroupProgress(
        models_, targets_, states_, options, contact_, &summaries_);
  }

  const TouchingSpindles scene_{ContactLevel::kCoarse, /*gap=*/500};
  const std::vector<const MuscleModel*> models_ = scene_.Models();
  const std::vector<MuscleTarget> targets_ = scene_.Targets();
  std::vector<MuscleState> states_ = scene_.RestStates();
  GroupContact contact_ = scene_.Contact();
  std::vector<SolverSummary> summaries_;
};

TEST_F(GroupProgressTest, StepLengthsFollowTheSchedule) {
  GroupIterationOptions options;
  options.step_length = {0.5, 0.1, 0.5};
  options.min_volume_fraction = 0.2;
  GroupProgress progress = Progress(options);
  for (const double alpha : {0.5, 0.25, 0.125, 0.1, 0.1}) {
    EXPECT_EQ(progress.alpha(), alpha);
    // The shortened step corrects alpha of the volume error, but no less than
    // the least share.
    EXPECT_DOUBLE_EQ(alpha / progress.volume_alpha(), std::max(alpha, 0.2));
    Iterate(&progress, 1, 0);
  }
  ASSERT_EQ(summaries_[0].history.size(), 5u);
  EXPECT_EQ(summaries_[0].history[1].alpha, 0.25);
  EXPECT_EQ(summaries_[0].iterations, 5);
}

TEST_F(GroupProgressTest, ConvergesOnceMeanShapesAgreeOnTheFineVolume) {
  GroupIterationOptions options;
  options.window = 2;
  options.drift_threshold = 0.25;
  GroupProgress progress = Progress(options);
  // Two windows whose means are 4 mm apart.
  for (int k = 0; k < 4; ++k) Iterate(&progress, 2, 0);
  EXPECT_FALSE(progress.IsOver());
  EXPECT_FALSE(progress.is_fine_volume());
  // To and fro: single moves of 1 mm, means that agree.
  for (int k = 0; k < 4; ++k) Iterate(&progress, k % 2 ? -1 : 1, 0);
  EXPECT_TRUE(progress.is_fine_volume());
  EXPECT_FALSE(progress.IsOver());
  for (int k = 0; k < 2; ++k) Iterate(&progress, k % 2 ? -1 : 1, 0);
  EXPECT_TRUE(progress.IsOver());
  for (const SolverSummary& summary : summaries_) {
    EXPECT_EQ(summary.stop_reason, StopReason::kConverged);
    EXPECT_EQ(summary.iterations, 10);
  }
  EXPECT_NEAR(summaries_[0].max_step, 1, 1e-12);
  EXPECT_EQ(summaries_[1].max_step, 0);
}

TEST_F(GroupProgressTest, DoesNotConvergeBeforeTheVolumeIsKept) {
  GroupIterationOptions options;
  options.window = 1;
  options.volume_tolerance = 0.02;
  GroupProgress progress = Progress(options);
  for (int k = 0; k < 5; ++k) Iterate(&progress, 0, -0.03);
  EXPECT_TRUE(progress.is_fine_volume());
  EXPECT_FALSE(progress.IsOver());
  Iterate(&progress, 0, -0.01);
  EXPECT_TRUE(progress.IsOver());
  EXPECT_EQ(summaries_[0].stop_reason, StopReason::kConverged);
}

TEST_F(GroupProgressTest, EndsAtTheIterationLimit) {
  GroupIterationOptions options;
  options.max_iterations = 3;
  GroupProgress progress = Progress(options);
  for (int k = 0; k < 3; ++k) {
    EXPECT_FALSE(progress.IsOver());
    Iterate(&progress, 1, 0);
  }
  EXPECT_TRUE(progress.IsOver());
  EXPECT_EQ(summaries_[1].stop_reason, StopReason::kIterationLimit);
  EXPECT_EQ(summaries_[1].message, "max_iterations reached");
}

TEST_F(GroupProgressTest, OneMuscleThatFailsFailsAllAndIsNamed) {
  GroupIterationOptions options;
  options.window = 1;
  GroupProgress progress = Progress(options);
  progress.Fail(1, "the reason");
  EXPECT_TRUE(progress.IsOver());
  // Whatever is recorded afterwards.
  for (int k = 0; k < 3; ++k) Iterate(&progress, 0, 0);
  for (const SolverSummary& summary : summaries_) {
    EXPECT_EQ(summary.stop_reason, StopReason::kFailed);
    EXPECT_EQ(summary.message, models_[1]->name + ": the reason");
  }
}

TEST_F(GroupProgressTest, SummariesHaveEnergiesAndVolumes) {
  states_[0].coarse *= 1.1;
  const GroupIterationOptions options;
  GroupProgress progress = Progress(options);
  EXPECT_EQ(summaries_[0].initial_energy,
            LinearEnergy(*models_[0], targets_[0], states_[0].coarse));
  states_[0].coarse = 2 * models_[0]->coarse_rest;
  progress.Finish(states_);
  EXPECT_EQ(summaries_[0].final_energy,
            LinearEnergy(*models_[0], targets_[0], states_[0].coarse));
  EXPECT_NEAR(summaries_[0].volume_ratio, 8, 1e-10);
  EXPECT_NEAR(summaries_[1].volume_ratio, 1, 1e-10);
}

TEST(GroupIterationOptions, DefaultsAreValid) {
  ExpectValid(GroupIterationOptions());
}

TEST(GroupIterationOptions, RefuseValuesOutOfRange) {
  ExpectRefused<GroupIterationOptions>(
      [](auto* options) { options->step_length.final_alpha = 0; },
      "StepLengthSchedule::final_alpha is 0, allowed: above 0 and at most "
      "initial_alpha");
  ExpectRefused<GroupIterationOptions>(
      [](auto* options) { options->min_volume_fraction = 1.5; },
      "GroupIterationOptions::min_volume_fraction is 1.5, allowed: 0 to 1");
  ExpectRefused<GroupIterationOptions>(
      [](auto* options) { options->window = 0; },
      "GroupIterationOptions::window is 0, allowed: above 0");
  ExpectRefused<GroupIterationOptions>(
      [](auto* options) { options->drift_threshold = 0; },
      "GroupIterationOptions::drift_threshold is 0, allowed: above 0");
  ExpectRefused<GroupIterationOptions>(
      [](auto* options) { options->volume_tolerance = -1; },
      "GroupIterationOptions::volume_tolerance is -1, allowed: above 0");
  ExpectRefused<GroupIterationOptions>(
      [](auto* options) { options->max_iterations = 0; },
      "GroupIterationOptions::max_iterations is 0, allowed: above 0");
}

}  // namespace
}  // namespace musclewarp
