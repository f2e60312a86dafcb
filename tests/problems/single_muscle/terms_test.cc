// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <ceres/gradient_checker.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "problems/single_muscle/coordinates_term.h"
#include "problems/single_muscle/laplacian_term.h"
#include "problems/single_muscle/one_sided_term.h"
#include "problems/single_muscle/volume_term.h"
#include "problems/single_muscle/whitened_linear_term.h"
#include "problems/single_muscle/whitening.h"
#include "support/muscles.h"

namespace musclewarp {
namespace {

// Of the derivatives, relative; the numeric ones (Ridders) are good to 1e-9.
constexpr double kDerivative = 1e-7;

std::vector<const double*> Blocks(const Points& points) {
  std::vector<const double*> blocks;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    blocks.push_back(points.data() + 3 * i);
  }
  return blocks;
}

void ExpectRightDerivative(const ceres::CostFunction& term,
                           const Points& parameters) {
  ceres::NumericDiffOptions options;
  ceres::GradientChecker checker(
      &term,
      static_cast<const std::vector<const ceres::Manifold*>*>(nullptr),
      options);
  ceres::GradientChecker::ProbeResults results;
  const std::vector<const double*> blocks = Blocks(parameters);
  EXPECT_TRUE(checker.Probe(blocks.data(), kDerivative, &results))
      << results.error_log;
}

Points RandomPoints(int count) {
  std::mt19937 engine(5);
  Points points(count, 3);
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    points.data()[i] = 10 * (engine() / 4294967296.0) - 5;
  }
  return points;
}

Eigen::VectorXd Residuals(const ceres::CostFunction& term,
                          const Points& parameters) {
  Eigen::VectorXd residuals(term.num_residuals());
  const std::vector<const double*> blocks = Blocks(parameters);
  EXPECT_TRUE(term.Evaluate(blocks.data(), residuals.data(), nullptr));
  return residuals;
}

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

TEST(LaplacianTerm, IsTheWeightedSumMinusDelta) {
  Points x(3, 3);
  x << 1, 1, 1, 3, 1, 1, 1, 5, 1;
  const double delta[3] = {0.5, 0, 7};
  const std::unique_ptr<ceres::CostFunction> term(
      LaplacianTerm::Create({0.25, 0.75}, delta));
  // 0.25 (2, 0, 0) + 0.75 (0, 4, 0) - delta
  EXPECT_TRUE(Residuals(*term, x).isApprox(Eigen::Vector3d(0, 3, -7)));
  ExpectRightDerivative(*term, RandomPoints(3));
}

TEST(CoordinatesTerm, IsTheDistanceToTheTarget) {
  Eigen::RowVectorXd row(3);
  row << 0.5, 0.25, 0.25;
  const Points x = RandomPoints(3);
  const Eigen::RowVector3d point = row * x;
  const std::unique_ptr<ceres::CostFunction> at_target(
      CoordinatesTerm::Create(row, point.data()));
  EXPECT_LT(Residuals(*at_target, x).norm(), 1e-15);
  const Eigen::RowVector3d away = point - Eigen::RowVector3d(1, 2, 3);
  const std::unique_ptr<ceres::CostFunction> term(
      CoordinatesTerm::Create(row, away.data()));
  EXPECT_TRUE(Residuals(*term, x).isApprox(Eigen::Vector3d(1, 2, 3)));
  ExpectRightDerivative(*term, RandomPoints(3));
}

TEST(WhitenedLinearTerm, IsItsUnknown) {
  const std::unique_ptr<ceres::CostFunction> term(WhitenedLinearTerm::Create());
  const Points y = RandomPoints(1);
  EXPECT_EQ(Residuals(*term, y), Eigen::VectorXd(y.row(0).transpose()));
  ExpectRightDerivative(*term, y);
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
    ASSERT_TRUE(
        term.Evaluate(Blocks(place).data(), residuals.data(), blocks.data()));
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

TEST(VolumeTerm, IsTheErrorAsAThicknessPlusTheMultiplier) {
  const MuscleModel model = SpindleModel();
  HardConstraint constraint;
  constraint.penalty = 100;
  VolumeEvaluator volume(model, nullptr);
  const MuscleUnknowns unknowns(
      model, MuscleTarget(), MuscleFormulation::kBlocks, model.coarse_rest);
  const VolumeTerm term(&unknowns, &volume, &constraint);
  EXPECT_NEAR(Residuals(term, model.coarse_rest)[0], 0, 1e-10);
  // Twice the size has eight times the volume.
  EXPECT_NEAR(Residuals(term, 2 * model.coarse_rest)[0],
              10 * 7 * model.rest_volume / model.rest_area,
              1e-9);
  constraint.multiplier = 30;
  EXPECT_NEAR(Residuals(term, model.coarse_rest)[0], 3, 1e-10);
}

TEST(VolumeTerm, HasTheRightDerivative) {
  const MuscleModel model = SpindleModel();
  HardConstraint constraint;
  constraint.penalty = 100;
  constraint.multiplier = 5;
  VolumeEvaluator volume(model, nullptr);
  const MuscleUnknowns unknowns(
      model, MuscleTarget(), MuscleFormulation::kBlocks, model.coarse_rest);
  const VolumeTerm term(&unknowns, &volume, &constraint);
  // Shaken: symmetry makes entries vanish, which have no relative error.
  const Points shaken =
      model.coarse_rest + RandomPoints(model.coarse_rest.rows());
  ExpectRightDerivative(term, shaken);
}

TEST(VolumeTerm, HasTheRightDerivativeWhitened) {
  const MuscleModel model = SpindleModel();
  HardConstraint constraint;
  constraint.penalty = 100;
  constraint.multiplier = 5;
  const MuscleTarget target = TargetOf(model, BentPose(0.5), {});
  const Points shaken =
      model.coarse_rest + RandomPoints(model.coarse_rest.rows());
  VolumeEvaluator volume(model, nullptr);
  const MuscleUnknowns unknowns(
      model, target, MuscleFormulation::kWhitened, shaken);
  const VolumeTerm term(&unknowns, &volume, &constraint);
  ExpectRightDerivative(term,
                        Whitening(model, target).WhitenedFromCoarse(shaken));
}

}  // namespace musclewarp
