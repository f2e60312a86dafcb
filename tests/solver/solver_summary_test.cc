// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/solver_summary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace musclewarp {
namespace {

using ::testing::HasSubstr;

// A converged solve of `iterations` iterations, the step of each a tenth of the
// one before.
SolverSummary Converged(int iterations, double initial_energy) {
  SolverSummary summary;
  summary.stop_reason = StopReason::kConverged;
  summary.message = "";
  summary.iterations = iterations;
  summary.initial_energy = initial_energy;
  summary.final_energy = initial_energy / 2;
  summary.volume_ratio = 1.25;
  summary.wall_ms = 10.0 * iterations;
  double step = 1;
  for (int k = 0; k < iterations; ++k, step /= 10) {
    summary.history.push_back({step, 0.5 * step, 0.5, k > 0});
  }
  summary.max_step = 10 * step;
  return summary;
}

}  // namespace

TEST(SolverSummary, OfASolveThatWasForgottenIsNotUsable) {
  const SolverSummary summary;
  EXPECT_FALSE(summary.IsSolutionUsable());
  EXPECT_THAT(summary.BriefReport(), HasSubstr("not_run"));
  EXPECT_THAT(summary.BriefReport(), HasSubstr("the solver was not called"));
}

TEST(SolverSummary, IsUsableIfAndOnlyIfTheSolverConverged) {
  SolverSummary summary = Converged(3, 8);
  EXPECT_TRUE(summary.IsSolutionUsable());
  for (const StopReason reason : {StopReason::kNotRun,
                                  StopReason::kIterationLimit,
                                  StopReason::kFailed}) {
    summary.stop_reason = reason;
    EXPECT_FALSE(summary.IsSolutionUsable()) << ToString(reason);
  }
}

TEST(SolverSummary, NamesEveryStopReasonAsTheReportsDo) {
  EXPECT_EQ(ToString(StopReason::kNotRun), "not_run");
  EXPECT_EQ(ToString(StopReason::kConverged), "converged");
  EXPECT_EQ(ToString(StopReason::kIterationLimit), "iteration_limit");
  EXPECT_EQ(ToString(StopReason::kFailed), "failed");
}

TEST(SolverSummary, ReportsOutcomeAndFigures) {
  SolverSummary summary = Converged(3, 8);
  EXPECT_EQ(summary.BriefReport(),
            "converged after 3 iterations, 30.0 ms, energy 8.0000 -> 4.0000 "
            "mm^2, volume ratio 1.25000000");
  summary.message = "a reason";
  EXPECT_THAT(summary.BriefReport(), HasSubstr(" (a reason)"));
}

TEST(SolverSummary, FullReportHasALinePerIteration) {
  const SolverSummary summary = Converged(3, 8);
  const std::string report = summary.FullReport();
  EXPECT_EQ(report.find(summary.BriefReport()), 0u);
  // The brief report and the heading come before the iterations.
  EXPECT_EQ(std::count(report.begin(), report.end(), '\n'), 2 + 3);
  const size_t coarse = report.find("coarse mesh");
  const size_t fine = report.find("fine mesh");
  ASSERT_NE(coarse, std::string::npos);
  ASSERT_NE(fine, std::string::npos);
  EXPECT_LT(coarse, fine);
}

TEST(MergedSummary, AddsUpWorkAndEndsAsTheSecondSolve) {
  const SolverSummary first = Converged(3, 8);
  SolverSummary second = Converged(2, 5);
  second.stop_reason = StopReason::kIterationLimit;
  second.message = "max_iterations reached";
  second.volume_ratio = 1;
  const SolverSummary merged = MergedSummary(first, second);
  EXPECT_EQ(merged.iterations, 5);
  EXPECT_EQ(merged.wall_ms, 50);
  EXPECT_EQ(merged.initial_energy, 8);
  EXPECT_EQ(merged.final_energy, 2.5);
  EXPECT_EQ(merged.stop_reason, StopReason::kIterationLimit);
  EXPECT_EQ(merged.message, "max_iterations reached");
  EXPECT_EQ(merged.volume_ratio, 1);
  EXPECT_EQ(merged.max_step, second.max_step);
  ASSERT_EQ(merged.history.size(), 5u);
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(merged.history[k].max_step, first.history[k].max_step);
  }
  for (int k = 0; k < 2; ++k) {
    EXPECT_EQ(merged.history[3 + k].max_step, second.history[k].max_step);
  }
}

}  // namespace musclewarp
