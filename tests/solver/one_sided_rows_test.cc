// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/one_sided_rows.h"

#include <gtest/gtest.h>

#include <vector>

#include "musclewarp/solver/gauss_newton.h"
#include "support/muscles.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// A plane for every `stride`-th vertex that would have it move by `depth`
// against its place along x, less for every other of these vertices.
std::vector<VertexHalfSpace> PlanesAcrossX(const MuscleModel& model,
                                           int stride,
                                           double depth) {
  std::vector<VertexHalfSpace> planes;
  for (int v = 0; v < model.fine_rest.rows(); v += stride) {
    const double sign = model.fine_rest(v, 0) > 0 ? -1 : 1;
    const double place = sign * model.fine_rest(v, 0);
    const double wanted = planes.size() % 2 == 0 ? depth : depth / 2;
    planes.push_back({v, {{sign, 0, 0}, place + wanted}});
  }
  return planes;
}

}  // namespace

TEST(OneSidedRows, AreThePlanesOfTheirVertices) {
  const MuscleModel model = SpindleModel();
  const std::vector<VertexHalfSpace> planes = PlanesAcrossX(model, 7, 3);
  const OneSidedRows rows = OneSidedRowsOf(planes, 0.5);
  ASSERT_EQ(rows.size(), static_cast<int>(planes.size()));
  EXPECT_EQ(rows.weight, 0.5);
  const Eigen::VectorXd depths =
      OneSidedDepths(rows, FineFromCoarse(model, rows), model.coarse_rest);
  for (int k = 0; k < rows.size(); ++k) {
    EXPECT_EQ(rows.vertices[k], planes[k].vertex);
    EXPECT_EQ(RowVector3d(rows.normals.row(k)), planes[k].space.normal);
    EXPECT_NEAR(depths[k], k % 2 == 0 ? 3 : 1.5, 1e-9);
  }
}

// Against a dense factorisation of all 3 N unknowns.
TEST(OneSidedSystem, SolvesWithTheActiveRows) {
  const MuscleModel model = SpindleModel();
  OneSidedRows rows = OneSidedRowsOf(PlanesAcrossX(model, 5, 3), 0.7);
  // Every other row is not active: its vertex is beyond the plane.
  for (int k = 0; k < rows.size(); k += 2) rows.levels[k] -= 10;
  const RowMajorMatrix w = FineFromCoarse(model, rows);
  const Eigen::VectorXd depths = OneSidedDepths(rows, w, model.coarse_rest);

  const Eigen::Index count = model.coarse_rest.rows();
  const Eigen::MatrixXd a = model.normal_matrix.reconstructedMatrix();
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(3 * count, 3 * count);
  Eigen::VectorXd descent = Eigen::VectorXd::Zero(3 * count);
  for (int c = 0; c < 3; ++c) {
    dense.block(c * count, c * count, count, count) = a;
  }
  int active = 0;
  for (int k = 0; k < rows.size(); ++k) {
    if (depths[k] <= 0) continue;
    ++active;
    Eigen::VectorXd row(3 * count);
    for (int c = 0; c < 3; ++c) {
      row.segment(c * count, count) =
          rows.weight * rows.normals(k, c) * w.row(k).transpose();
    }
    dense += row * row.transpose();
    descent += rows.weight * depths[k] * row;
  }
  ASSERT_GT(active, 5);
  ASSERT_LT(active, rows.size());
  const Eigen::VectorXd expected = dense.ldlt().solve(descent);

  OneSidedSystem system(model, rows);
  system.UpdateActiveRows(model.coarse_rest);
  // At rest the step of the linear energy is zero.
  const Points step = system.CorrectedStep(Points::Zero(count, 3));
  for (int c = 0; c < 3; ++c) {
    EXPECT_LT((step.col(c) - expected.segment(c * count, count)).norm(),
              1e-8 * expected.norm());
  }
}

TEST(OneSidedSystem, ChangesNothingWithoutRows) {
  const MuscleModel model = SpindleModel();
  const OneSidedRows none;
  OneSidedSystem system(model, none);
  system.UpdateActiveRows(model.coarse_rest);
  EXPECT_EQ(system.CorrectedStep(model.coarse_rest), model.coarse_rest);
  EXPECT_EQ(system.CorrectedSolution(model.coarse_rest), model.coarse_rest);
}

// They go the farther the more the rows weigh, but no row takes its vertex
// beyond the plane, and the volume is kept.
TEST(OneSidedRows, MoveVerticesTowardsTheirPlanes) {
  const MuscleModel model = SpindleModel();
  MuscleTarget target = TargetOf(model, ScenePose(), {});
  Eigen::Index v;
  model.fine_rest.col(0).maxCoeff(&v);
  const double level = 3 - model.fine_rest(v, 0);
  double least = 3;
  for (const double weight : {0.1, 0.3, 1.0, 10.0}) {
    target.one_sided =
        OneSidedRowsOf({{static_cast<int>(v), {{-1, 0, 0}, level}}}, weight);
    Points coarse = model.coarse_rest;
    SolverSummary summary;
    SolveGaussNewton(model, target, {}, &coarse, &summary);
    ASSERT_TRUE(summary.IsSolutionUsable()) << summary.FullReport();
    EXPECT_NEAR(summary.volume_ratio, 1, 1e-8);
    const double depth =
        level +
        (RowsOf(model.fine_from_coarse, {static_cast<int>(v)}) * coarse)(0, 0);
    EXPECT_LT(depth, least);
    EXPECT_GE(depth, 0);
    least = depth;
  }
}

}  // namespace musclewarp
