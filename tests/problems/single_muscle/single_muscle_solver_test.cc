// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "problems/single_muscle/single_muscle_solver.h"

#include <gtest/gtest.h>

#include "musclewarp/solver/gauss_newton.h"
#include "support/invalid_options.h"
#include "support/muscles.h"

namespace musclewarp {
namespace {

// Required of the distance between the results of two solvers, mm.
constexpr double kSameMinimum = 1e-3;

Points SolveWithCeres(const MuscleModel& model,
                      const MuscleTarget& target,
                      MuscleFormulation formulation) {
  Points coarse = model.coarse_rest;
  SolverSummary summary;
  SolveSingleMuscle(
      model, target, SingleMuscleOptions::For(formulation), &coarse, &summary);
  EXPECT_EQ(summary.stop_reason, StopReason::kConverged)
      << summary.FullReport();
  EXPECT_NEAR(summary.volume_ratio, 1, 1e-6);
  return Product(model.fine_from_coarse, coarse);
}

Points SolveWithReference(const MuscleModel& model,
                          const MuscleTarget& target) {
  Points coarse = model.coarse_rest;
  SolverSummary summary;
  SolveGaussNewton(model, target, {}, &coarse, &summary);
  EXPECT_EQ(summary.stop_reason, StopReason::kConverged);
  return Product(model.fine_from_coarse, coarse);
}

double Distance(const Points& a, const Points& b) {
  return (a - b).rowwise().norm().maxCoeff();
}

// Rows that ask the vertices of the upper half of the muscle to go by `depth`
// along -x from `free`, those of the lower half along x.
OneSidedRows RowsFromBothSides(const MuscleModel& model,
                               const Points& free,
                               double depth) {
  std::vector<VertexHalfSpace> planes;
  for (int v = 0; v < free.rows(); v += 3) {
    const double sign = model.fine_rest(v, 2) > 0 ? -1 : 1;
    planes.push_back({v, {{sign, 0, 0}, sign * free(v, 0) + depth}});
  }
  return OneSidedRowsOf(planes, 0.5);
}

}  // namespace

TEST(SingleMuscleOptions, AreValidForBothFormulations) {
  for (const auto formulation :
       {MuscleFormulation::kWhitened, MuscleFormulation::kBlocks}) {
    ExpectValid(SingleMuscleOptions::For(formulation));
  }
}

TEST(SingleMuscleOptions, RefuseValuesOutOfRange) {
  ExpectRefused<SingleMuscleOptions>(
      [](auto* options) { options->fine_volume_threshold = 0; },
      "SingleMuscleOptions::fine_volume_threshold is 0, allowed: above 0");
  ExpectRefused<SingleMuscleOptions>(
      [](auto* options) { options->hard_constraint.max_rounds = 0; },
      "HardConstraintOptions::max_rounds is 0, allowed: above 0");
}

TEST(SingleMuscleSolver, BothFormulationsAndTheReferenceFindOneMinimum) {
  const MuscleModel model = SpindleModel();
  for (const double angle : {0.0, 0.5, 1.0}) {
    const MuscleTarget target = TargetOf(model, BentPose(angle), {});
    const Points reference = SolveWithReference(model, target);
    EXPECT_LT(
        Distance(reference,
                 SolveWithCeres(model, target, MuscleFormulation::kWhitened)),
        kSameMinimum);
    EXPECT_LT(
        Distance(reference,
                 SolveWithCeres(model, target, MuscleFormulation::kBlocks)),
        kSameMinimum);
  }
}

TEST(SingleMuscleSolver, AllFindOneMinimumWithOneSidedRows) {
  const MuscleModel model = SpindleModel();
  for (const double angle : {0.0, 0.5, 1.0}) {
    MuscleTarget target = TargetOf(model, BentPose(angle), {});
    const Points free = SolveWithReference(model, target);
    target.one_sided = RowsFromBothSides(model, free, 4);
    const Points reference = SolveWithReference(model, target);
    EXPECT_GT(Distance(reference, free), 1);
    for (const auto formulation :
         {MuscleFormulation::kWhitened, MuscleFormulation::kBlocks}) {
      EXPECT_LT(Distance(reference, SolveWithCeres(model, target, formulation)),
                kSameMinimum);
    }
  }
}

TEST(SingleMuscleSolver, AllFindOneMinimumWithRowsByArea) {
  MuscleModelOptions options;
  options.laplacian.weights = LaplacianWeights::kArea;
  options.attachment_weight = 8;
  const MuscleModel model = SpindleModel(options);
  MuscleTarget target = TargetOf(model, BentPose(1), {});
  const Points free = SolveWithReference(model, target);
  target.one_sided = RowsFromBothSides(model, free, 4);
  const Points reference = SolveWithReference(model, target);
  EXPECT_GT(Distance(reference, free), 1);
  for (const auto formulation :
       {MuscleFormulation::kWhitened, MuscleFormulation::kBlocks}) {
    EXPECT_LT(Distance(reference, SolveWithCeres(model, target, formulation)),
              kSameMinimum);
  }
}

TEST(SingleMuscleSolver, PlanesThatAreFarAwayChangeNothing) {
  const MuscleModel model = SpindleModel();
  MuscleTarget target = TargetOf(model, BentPose(0.5), {});
  const Points free = SolveWithReference(model, target);
  target.one_sided = RowsFromBothSides(model, free, 4);
  target.one_sided.levels.array() -= 5;
  EXPECT_LT(Distance(SolveWithReference(model, target), free), kSameMinimum);
  EXPECT_LT(
      Distance(SolveWithCeres(model, target, MuscleFormulation::kWhitened),
               free),
      kSameMinimum);
}

TEST(SingleMuscleSolver, RestInRestOut) {
  const MuscleModel model = SpindleModel();
  const MuscleTarget target = TargetOf(model, ScenePose(), {});
  for (const auto formulation :
       {MuscleFormulation::kWhitened, MuscleFormulation::kBlocks}) {
    EXPECT_LT(
        Distance(SolveWithCeres(model, target, formulation), model.fine_rest),
        1e-6);
  }
}

TEST(SingleMuscleSolver, TheResultDoesNotDependOnTheStart) {
  const MuscleModel model = SpindleModel();
  const MuscleTarget target = TargetOf(model, BentPose(0.8), {});
  const Points from_rest =
      SolveWithCeres(model, target, MuscleFormulation::kWhitened);
  Points coarse = 1.2 * model.coarse_rest;
  SolverSummary summary;
  SolveSingleMuscle(model, target, {}, &coarse, &summary);
  EXPECT_LT(Distance(Product(model.fine_from_coarse, coarse), from_rest),
            kSameMinimum);
}

}  // namespace musclewarp
