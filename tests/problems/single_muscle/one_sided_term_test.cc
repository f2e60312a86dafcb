// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "problems/single_muscle/one_sided_term.h"

#include <gtest/gtest.h>

#include <vector>

#include "problems/single_muscle/term_checks.h"
#include "support/muscles.h"

namespace musclewarp {

namespace {

// Rows for vertices all over the mesh, with depths of both signs.
OneSidedRows RowsAllOver(const MuscleModel& model) {
  OneSidedRows rows;
  rows.weight = 0.7;
  for (int v = 0; v < model.fine_rest.rows(); v += 20) {
    rows.vertices.push_back(v);
  }
  rows.normals = RandomPoints(rows.size()).rowwise().normalized();
  const Points places = model.fine_rest(rows.vertices, Eigen::all);
  rows.levels = rows.normals.cwiseProduct(places).rowwise().sum();
  for (int k = 0; k < rows.size(); ++k) rows.levels[k] += k % 2 ? 30 : -30;
  return rows;
}

}  // namespace

TEST(OneSidedTerm, IsZeroIfAllVerticesAreBeyondTheirPlanes) {
  const MuscleModel model = SpindleModel();
  OneSidedRows rows = RowsAllOver(model);
  rows.levels.array() -= 31;
  const MuscleUnknowns unknowns(
      model, MuscleTarget(), MuscleFormulation::kBlocks, model.coarse_rest);
  const OneSidedTerm term(model, &rows, &unknowns);
  EXPECT_EQ(Residuals(term, model.coarse_rest),
            Eigen::VectorXd::Zero(rows.size()));
}

TEST(OneSidedTerm, IsTheDepthOnTheWrongSideOfAPlane) {
  const MuscleModel model = SpindleModel();
  const OneSidedRows rows = RowsAllOver(model);
  const MuscleUnknowns unknowns(
      model, MuscleTarget(), MuscleFormulation::kBlocks, model.coarse_rest);
  const OneSidedTerm term(model, &rows, &unknowns);
  const Eigen::VectorXd residuals = Residuals(term, model.coarse_rest);
  for (int k = 0; k < rows.size(); ++k) {
    EXPECT_NEAR(residuals[k], k % 2 ? 0.7 * 30 : 0, 1e-9);
  }
}

// Between its kinks the term is linear, so that differences are exact, and as
// a whole: single derivatives are as small as 1e-9.
TEST(OneSidedTerm, HasTheRightDerivativeInBothFormulations) {
  const MuscleModel model = SpindleModel();
  const OneSidedRows rows = RowsAllOver(model);
  const MuscleTarget target = TargetOf(model, BentPose(0.1), {});
  for (const auto formulation :
       {MuscleFormulation::kWhitened, MuscleFormulation::kBlocks}) {
    MuscleUnknowns unknowns(model, target, formulation, model.coarse_rest);
    const OneSidedTerm term(model, &rows, &unknowns);
    const int count = unknowns.num_blocks();
    const Points place = Eigen::Map<const Points>(unknowns.data(), count, 3);
    const Points step = 0.01 * RandomPoints(count);
    std::vector<Points> jacobian(count, Points(rows.size(), 3));
    std::vector<double*> blocks;
    for (Points& block : jacobian) blocks.push_back(block.data());
    Eigen::VectorXd residuals(rows.size());
    ASSERT_TRUE(term.Evaluate(
        TermBlocks(place).data(), residuals.data(), blocks.data()));
    Eigen::VectorXd change = Eigen::VectorXd::Zero(rows.size());
    for (int j = 0; j < count; ++j) {
      change += jacobian[j] * step.row(j).transpose();
    }
    const Eigen::VectorXd difference =
        Residuals(term, place + step) - Residuals(term, place - step);
    EXPECT_GT(change.norm(), 1e-3);
    EXPECT_LT((difference - 2 * change).norm(), 1e-9 * change.norm());
  }
}

}  // namespace musclewarp
