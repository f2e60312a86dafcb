// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/deformer/solver_configuration.h"

#include <gtest/gtest.h>

#include <string>

#include "support/muscles.h"

namespace musclewarp {
namespace {

// All formulations are to find one minimum; what stops them is 1e-4 mm.
constexpr double kSameMinimum = 1e-3;

TEST(SolverConfiguration, EveryNameSolvesTheSameProblem) {
  const MuscleModel model = SpindleModel();
  const MuscleTarget target = TargetOf(model, BentPose(0.3), {});
  Points reference;
  for (const std::string& name : SolverConfigurationNames()) {
    const SolverConfiguration configuration = SolverConfigurationNamed(name);
    EXPECT_EQ(configuration.name, name);
    EXPECT_EQ(configuration.is_reference, name == "reference");
    std::string error;
    if (!configuration.IsValid(&error)) continue;  // a library is not there
    Points coarse = model.coarse_rest;
    SolverSummary summary;
    SolversOf(configuration).single(model, target, &coarse, &summary);
    EXPECT_TRUE(summary.IsSolutionUsable()) << name << summary.BriefReport();
    if (reference.rows() == 0) reference = coarse;
    EXPECT_LT((coarse - reference).rowwise().norm().maxCoeff(), kSameMinimum)
        << name;
  }
}

TEST(SolversOf, KeepTheirOwnCopyOfTheOptions) {
  const MuscleModel model = SpindleModel();
  const MuscleTarget target = TargetOf(model, BentPose(0.3), {});
  MuscleSolvers solvers;
  {
    SolverConfiguration configuration = SolverConfigurationNamed("reference");
    configuration.gauss_newton.max_iterations = 1;
    solvers = SolversOf(configuration);
    configuration.gauss_newton.max_iterations = 100;
  }
  Points coarse = model.coarse_rest;
  SolverSummary summary;
  solvers.single(model, target, &coarse, &summary);
  EXPECT_EQ(summary.iterations, 1);
  EXPECT_EQ(summary.stop_reason, StopReason::kIterationLimit);
}

}  // namespace
}  // namespace musclewarp
