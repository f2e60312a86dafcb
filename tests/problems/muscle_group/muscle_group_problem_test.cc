// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "problems/muscle_group/muscle_group_problem.h"

#include <ceres/crs_matrix.h>
#include <gtest/gtest.h>

#include "musclewarp/solver/volume_constraint.h"
#include "problems/single_muscle/single_muscle_problem.h"
#include "support/muscle_groups.h"

namespace musclewarp {
namespace {

// What Ceres evaluates after contact has put vertices back and masked them.
class AfterContact : public ::testing::TestWithParam<MuscleFormulation> {};

TEST_P(AfterContact, CeresSeesTheRolledBackStateAndNoMaskedRow) {
  const TouchingSpindles scene(ContactLevel::kCoarse);
  GroupContact contact = scene.Contact();
  std::vector<MuscleState> states = scene.RestStates();
  contact.Start(&states);
  MuscleGroupProblem group(scene.Models(), scene.Targets(), GetParam(), states);
  states[0].coarse.rowwise() += Eigen::RowVector3d(0.5, 0, 0);
  const Points stepped = states[0].coarse;
  contact.AfterStep(0.5, &states);
  ASSERT_NE(states[0].coarse, stepped);
  group.SetStates(states);

  // The residual of the volume, the last of a muscle, is that of the state.
  std::vector<double> residuals;
  std::vector<double> gradient;
  ceres::CRSMatrix jacobian;
  ceres::Problem::EvaluateOptions in_order;  // not of first appearance
  for (const auto& unknowns : group.unknowns) {
    for (double* block : unknowns->Blocks()) {
      in_order.parameter_blocks.push_back(block);
    }
  }
  group.problem.Evaluate(in_order, nullptr, &residuals, &gradient, &jacobian);
  const MuscleModel& model = scene.models[0];
  // Through whitening and back: rounding of coordinates of size 100.
  EXPECT_LT((group.unknowns[0]->Coarse() - states[0].coarse).norm(), 1e-9);
  const int n = static_cast<int>(model.coarse_rest.rows());
  // The volume comes after the linear rows of its muscle.
  int row = 3 * n;
  if (GetParam() == MuscleFormulation::kBlocks) {
    row +=
        3 * static_cast<int>(model.skeleton.rows() + model.attachment.rows());
  }
  ASSERT_EQ(jacobian.rows[row + 1] - jacobian.rows[row], 3 * n);
  Points slope(n, 3);
  for (int k = 0; k < 3 * n; ++k) {
    slope.data()[k] = jacobian.values[jacobian.rows[row] + k];
  }
  if (GetParam() == MuscleFormulation::kWhitened) {
    // d/dX = U^T d/dY
    slope = model.normal_matrix.matrixL() * slope;
  }
  ASSERT_FALSE(states[0].corrections.held_coarse.IsEmpty());
  for (const int v : states[0].corrections.held_coarse.vertices) {
    // Exact for plain blocks; what whitening rounds.
    EXPECT_LT(slope.row(v).norm(), 1e-12 * slope.norm());
  }
  EXPECT_GT(slope.norm(), 0);
  EXPECT_NEAR(
      residuals[row],
      group.constraints[0]->Residual(
          FineVolumeError(model, states[0].coarse, states[0].corrections) /
          model.rest_area),
      1e-9);
}

INSTANTIATE_TEST_SUITE_P(Formulations,
                         AfterContact,
                         ::testing::Values(MuscleFormulation::kBlocks,
                                           MuscleFormulation::kWhitened));

TEST(MuscleGroupProblem, CostsTheSumOfItsMuscles) {
  const TouchingSpindles scene(ContactLevel::kCoarse);
  std::vector<MuscleState> states = scene.RestStates();
  states[0].coarse *= 1.1;
  const std::vector<MuscleTarget> targets = scene.Targets();
  MuscleGroupProblem group(
      scene.Models(), targets, MuscleFormulation::kBlocks, states);
  for (const VolumeMesh mesh : {VolumeMesh::kCoarse, VolumeMesh::kFine}) {
    group.SetVolumeMesh(mesh);
    double sum = 0;
    for (size_t i = 0; i < states.size(); ++i) {
      VolumeEvaluator volume(scene.models[i], nullptr);
      volume.SetMesh(mesh);
      MuscleUnknowns unknowns(scene.models[i],
                              targets[i],
                              MuscleFormulation::kBlocks,
                              states[i].coarse);
      const HardConstraint constraint;
      ceres::Problem problem;
      AddMuscle(scene.models[i],
                targets[i],
                constraint,
                &volume,
                &unknowns,
                &problem);
      double cost = 0;
      problem.Evaluate({}, &cost, nullptr, nullptr, nullptr);
      sum += cost;
    }
    double cost = 0;
    group.problem.Evaluate({}, &cost, nullptr, nullptr, nullptr);
    EXPECT_GT(cost, 0);
    // Sums of squares in another order.
    EXPECT_NEAR(cost, sum, 1e-12 * sum);
  }
}

}  // namespace
}  // namespace musclewarp
