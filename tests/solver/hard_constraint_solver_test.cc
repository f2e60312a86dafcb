// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/hard_constraint_solver.h"

#include <ceres/autodiff_cost_function.h>
#include <gtest/gtest.h>

#include <cmath>

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

TEST(HardConstraintSolver, DefaultOptionsAreValid) {
  std::string error;
  EXPECT_TRUE(HardConstraintOptions().IsValid(&error)) << error;
}

TEST(HardConstraintSolver, NamesTheBrokenRule) {
  HardConstraintOptions options;
  options.initial_penalty = -1;
  std::string error;
  EXPECT_FALSE(options.IsValid(&error));
  EXPECT_NE(error.find("initial_penalty"), std::string::npos);
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
