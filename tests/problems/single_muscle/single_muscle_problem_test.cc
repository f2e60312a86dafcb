// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "problems/single_muscle/single_muscle_problem.h"

#include <ceres/problem.h>
#include <gtest/gtest.h>

#include "support/muscles.h"

namespace musclewarp {
namespace {

// Relative, of sums of squares.
constexpr double kCostRounding = 1e-9;

// The cost of the problem of a muscle at `coarse`.
double Cost(const MuscleModel& model,
            const MuscleTarget& target,
            MuscleFormulation formulation,
            const HardConstraint& constraint,
            const Points& coarse) {
  MuscleUnknowns unknowns(model, target, formulation, coarse);
  VolumeEvaluator volume(model, nullptr);
  ceres::Problem problem;
  AddMuscle(model, target, constraint, &volume, &unknowns, &problem);
  EXPECT_EQ(problem.NumParameterBlocks(), model.coarse_rest.rows());
  double cost = 0;
  EXPECT_TRUE(problem.Evaluate({}, &cost, nullptr, nullptr, nullptr));
  return cost;
}

class SingleMuscleProblem : public ::testing::TestWithParam<MuscleFormulation> {
 protected:
  static MuscleModel Model() {
    MuscleModelOptions options;
    options.attachment_weight = 1;
    return SpindleModel(options);
  }

  // The constant by which the cost falls short of the linear energy.
  double Constant() const {
    return GetParam() == MuscleFormulation::kBlocks
               ? 0
               : LinearEnergy(
                     model_, target_, UnconstrainedMinimizer(model_, target_));
  }

  const MuscleModel model_ = Model();
  MuscleTarget target_ = TargetOf(model_, BentPose(0.6), {});
  const Points place_ = 1.1 * model_.coarse_rest;
};

HardConstraint NoVolume() {
  HardConstraint constraint;
  constraint.penalty = 1e-300;
  return constraint;
}

TEST_P(SingleMuscleProblem, TheTermsAddUpToTheLinearEnergy) {
  for (const Points& coarse : {model_.coarse_rest, place_}) {
    const double energy = LinearEnergy(model_, target_, coarse);
    EXPECT_NEAR(
        Cost(model_, target_, GetParam(), NoVolume(), coarse) + Constant(),
        energy,
        kCostRounding * energy);
  }
}

TEST_P(SingleMuscleProblem, TheVolumeAddsHalfItsSquaredResidual) {
  HardConstraint constraint;
  constraint.penalty = 1e4;
  constraint.multiplier = 30;
  // 1.1 times the size has 1.331 times the volume.
  const double residual =
      constraint.Residual(0.331 * model_.rest_volume / model_.rest_area);
  const double with = Cost(model_, target_, GetParam(), constraint, place_);
  const double without = Cost(model_, target_, GetParam(), NoVolume(), place_);
  EXPECT_NEAR(with - without, 0.5 * residual * residual, kCostRounding * with);
}

TEST_P(SingleMuscleProblem, OneSidedRowsAddHalfTheirSquaredDepths) {
  const double without = Cost(model_, target_, GetParam(), NoVolume(), place_);
  const Points fine = Product(model_.fine_from_coarse, place_);
  // The first vertex is 3 mm on the wrong side of its plane, the second beyond.
  target_.one_sided = OneSidedRowsOf(
      {{5, {{1, 0, 0}, fine(5, 0) + 3}}, {9, {{0, 1, 0}, fine(9, 1) - 3}}}, 2);
  const double with = Cost(model_, target_, GetParam(), NoVolume(), place_);
  EXPECT_NEAR(with - without, 0.5 * (2 * 3) * (2 * 3), kCostRounding * with);
}

INSTANTIATE_TEST_SUITE_P(Formulations,
                         SingleMuscleProblem,
                         ::testing::Values(MuscleFormulation::kBlocks,
                                           MuscleFormulation::kWhitened));

}  // namespace
}  // namespace musclewarp
