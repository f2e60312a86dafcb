// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/hard_constraint_solver.h"

#include <ceres/autodiff_cost_function.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/invalid_options.h"

namespace musclewarp {
namespace {

// The point of the unit circle nearest to (3, 4), with the constraint
// x^2 + y^2 = 1.
struct NearPoint {
  template <typename T>
  bool operator()(const T* p, T* residual) const {
    residual[0] = p[0] - 3.0;
    residual[1] = p[1] - 4.0;
    return true;
  }
};

struct OnCircle {
  template <typename T>
  bool operator()(const T* p, T* residual) const {
    const T c = p[0] * p[0] + p[1] * p[1] - 1.0;
    residual[0] = std::sqrt(constraint->penalty) *
                  (c + constraint->multiplier / constraint->penalty);
    return true;
  }
  const HardConstraint* constraint;
};

SolverSummary SolveCircle(const HardConstraintOptions& options, double* p) {
  HardConstraint constraint;
  constraint.penalty = options.initial_penalty;
  ceres::Problem problem;
  problem.AddResidualBlock(
      new ceres::AutoDiffCostFunction<NearPoint, 2, 2>(new NearPoint),
      nullptr,
      p);
  problem.AddResidualBlock(new ceres::AutoDiffCostFunction<OnCircle, 1, 2>(
                               new OnCircle{&constraint}),
                           nullptr,
                           p);
  SolverSummary summary;
  SolveWithHardConstraint(
      options,
      [&] { return p[0] * p[0] + p[1] * p[1] - 1; },
      [&] { return Eigen::Vector2d(p[0], p[1]); },
      &problem,
      &constraint,
      &summary);
  return summary;
}

}  // namespace

TEST(HardConstraintOptions, DefaultsAreValid) {
  ExpectValid(HardConstraintOptions());
}

TEST(HardConstraintOptions, RefuseValuesOutOfRange) {
  ExpectRefused<HardConstraintOptions>(
      [](auto* options) { options->initial_penalty = -1; },
      "HardConstraintOptions::initial_penalty is -1, allowed: above 0 and at "
      "most max_penalty");
  ExpectRefused<HardConstraintOptions>(
      [](auto* options) { options->penalty_factor = 1; },
      "HardConstraintOptions::penalty_factor is 1, allowed: above 1");
  ExpectRefused<HardConstraintOptions>(
      [](auto* options) { options->violation_tolerance = 0; },
      "HardConstraintOptions::violation_tolerance is 0, allowed: above 0");
  ExpectRefused<HardConstraintOptions>(
      [](auto* options) { options->step_tolerance = 0; },
      "HardConstraintOptions::step_tolerance is 0, allowed: above 0");
  ExpectRefused<HardConstraintOptions>(
      [](auto* options) { options->max_rounds = 0; },
      "HardConstraintOptions::max_rounds is 0, allowed: above 0");
}

TEST(HardConstraintOptions, RefuseWhatCeresRefuses) {
  HardConstraintOptions options;
  options.ceres.max_num_iterations = -5;
  std::string error;
  EXPECT_FALSE(options.IsValid(&error));
  EXPECT_NE(error.find("max_num_iterations"), std::string::npos) << error;
}

TEST(HardConstraint, ResidualIsZeroWhereMultiplierAndViolationBalance) {
  HardConstraint constraint;
  constraint.penalty = 4;
  constraint.target = 1;
  EXPECT_EQ(constraint.Residual(1), 0);
  constraint.multiplier = 8;
  // sqrt(4) (3 - 1 + 8 / 4)
  EXPECT_EQ(constraint.Residual(3), 8);
  EXPECT_EQ(constraint.Residual(-1), 0);
}

TEST(HardConstraint, LearnsTheMultiplierWhileTheViolationFalls) {
  const HardConstraintOptions options;
  HardConstraint constraint;
  constraint.penalty = 100;
  EXPECT_TRUE(constraint.Update(options, -0.25, 1, /*is_minimum=*/false));
  EXPECT_EQ(constraint.multiplier, -25);
  EXPECT_EQ(constraint.penalty, 100);
}

TEST(HardConstraint, HardensUpToTheLimitWhenTheViolationDoesNotFall) {
  HardConstraintOptions options;
  options.max_penalty = 5000;
  HardConstraint constraint;
  constraint.penalty = 100;
  EXPECT_FALSE(constraint.Update(options, 0.26, 1, /*is_minimum=*/false));
  EXPECT_EQ(constraint.multiplier, 0);
  EXPECT_EQ(constraint.penalty, 1000);
  // At a minimum the multiplier grows by the penalty of that minimum.
  EXPECT_FALSE(constraint.Update(options, 0.5, 1, /*is_minimum=*/true));
  EXPECT_EQ(constraint.multiplier, 500);
  EXPECT_EQ(constraint.penalty, 5000);
}

TEST(HardConstraintSolver, ReachesTheConstrainedMinimum) {
  double p[2] = {-1, 2};
  const SolverSummary summary = SolveCircle(HardConstraintOptions(), p);
  EXPECT_EQ(summary.stop_reason, StopReason::kConverged) << summary.message;
  // The violation is below 1e-7, the step below 1e-5.
  EXPECT_NEAR(p[0], 0.6, 1e-5);
  EXPECT_NEAR(p[1], 0.8, 1e-5);
  EXPECT_NEAR(std::hypot(p[0], p[1]), 1, 1e-7);
}

TEST(HardConstraintSolver, SaysWhenItDidNotConverge) {
  HardConstraintOptions options;
  options.max_rounds = 1;
  double p[2] = {-1, 2};
  EXPECT_EQ(SolveCircle(options, p).stop_reason, StopReason::kIterationLimit);
}

}  // namespace musclewarp
