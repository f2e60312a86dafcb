// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/line_muscle.h"

#include <gtest/gtest.h>

#include <cmath>

namespace musclewarp {
namespace {

// A muscle along a bent line 100 mm long.
LineMuscle BentMuscle() {
  LineMuscle muscle;
  muscle.line.name = "bent";
  muscle.line.rest.resize(3, 3);
  muscle.line.rest << 0, 0, 0, 60, 0, 0, 60, 40, 0;
  muscle.volume = 5e4;
  return muscle;
}

// Numbers of doubles that are divided and multiplied a few times.
constexpr double kRounding = 1e-12;

TEST(EstimateMuscle, FibreAndTendonFillThePathAtRest) {
  const MuscleEstimate estimate = EstimateMuscle(BentMuscle());
  EXPECT_NEAR(estimate.optimal_fibre_length * std::cos(estimate.pennation) +
                  estimate.tendon_slack_length,
              100,
              100 * kRounding);
  EXPECT_GT(estimate.optimal_fibre_length, 0);
  EXPECT_GT(estimate.tendon_slack_length, 0);  // OpenSim wants both
}

TEST(EstimateMuscle, ForceIsThatOfThePhysiologicalCrossSection) {
  const LineMuscle muscle = BentMuscle();
  const MuscleEstimate estimate = EstimateMuscle(muscle);
  const double square_mm = muscle.volume / estimate.optimal_fibre_length;
  // 60 N/cm2 are 0.6 N/mm2.
  EXPECT_NEAR(estimate.max_isometric_force, 0.6 * square_mm, 1e-9);
}

TEST(EstimateMuscle, LinesThatShareTheVolumeHaveTheForceOfTheMuscle) {
  const LineMuscle whole = BentMuscle();
  LineMuscle third = whole;
  third.volume /= 3;
  const double force = EstimateMuscle(whole).max_isometric_force;
  EXPECT_NEAR(
      3 * EstimateMuscle(third).max_isometric_force, force, force * kRounding);
}

// Forces go with areas.
TEST(EstimateMuscle, FollowsTheSizeOfTheBody) {
  const LineMuscle human = BentMuscle();
  const double scale = 2.5;
  LineMuscle larger = human;
  larger.line.rest *= scale;
  larger.volume *= std::pow(scale, 3);
  const MuscleEstimate a = EstimateMuscle(human), b = EstimateMuscle(larger);
  EXPECT_NEAR(b.max_isometric_force / a.max_isometric_force,
              scale * scale,
              10 * kRounding);
  EXPECT_NEAR(
      b.optimal_fibre_length / a.optimal_fibre_length, scale, 10 * kRounding);
  EXPECT_NEAR(
      b.tendon_slack_length / a.tendon_slack_length, scale, 10 * kRounding);
}

}  // namespace
}  // namespace musclewarp
