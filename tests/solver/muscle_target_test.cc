// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/muscle_target.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "support/muscles.h"

namespace musclewarp {
namespace {

MuscleModelOptions WithAttachments(LaplacianWeights weights) {
  MuscleModelOptions options;
  options.laplacian.weights = weights;
  options.attachment_weight = 2;
  options.skeleton_weight = 1.5;
  return options;
}

Eigen::Matrix3d Turn() {
  return Eigen::AngleAxisd(1.2, Eigen::Vector3d(1, 2, -1).normalized())
      .toRotationMatrix();
}

}  // namespace

// With rows by area, and with the paper's.
class MuscleTargetTest : public ::testing::TestWithParam<LaplacianWeights> {};

TEST_P(MuscleTargetTest, RestHasNoEnergy) {
  const MuscleModel model = SpindleModel(WithAttachments(GetParam()));
  ASSERT_GT(model.attachment.rows(), 0);
  const MuscleTarget target = TargetOf(model, ScenePose(), {});
  EXPECT_LT(LinearEnergy(model, target, model.coarse_rest), 1e-20);
  EXPECT_LT((UnconstrainedMinimizer(model, target) - model.coarse_rest)
                .cwiseAbs()
                .maxCoeff(),
            1e-9);
}

TEST_P(MuscleTargetTest, ARigidMotionHasNoEnergy) {
  const MuscleModel model = SpindleModel(WithAttachments(GetParam()));
  const Eigen::Vector3d shift(100, -50, 20);
  const MuscleTarget target = TargetOf(model, RigidPose(Turn(), shift), {});
  Points moved = model.coarse_rest * Turn().transpose();
  moved.rowwise() += shift.transpose();
  EXPECT_LT(LinearEnergy(model, target, moved), 1e-18);
  EXPECT_LT(
      (UnconstrainedMinimizer(model, target) - moved).cwiseAbs().maxCoeff(),
      1e-6);
}

TEST_P(MuscleTargetTest, DescentIsMinusTheGradient) {
  const MuscleModel model = SpindleModel(WithAttachments(GetParam()));
  const MuscleTarget target = TargetOf(model, BentPose(0.8), {});
  Points coarse = model.coarse_rest;
  const Points descent = LinearDescent(model, target, coarse);
  for (Eigen::Index i = 0; i < coarse.size(); i += 11) {
    double& x = coarse.data()[i];
    const double x0 = x;
    // Quadratic: central differences are exact but for rounding.
    x = x0 + 1;
    const double plus = LinearEnergy(model, target, coarse);
    x = x0 - 1;
    const double minus = LinearEnergy(model, target, coarse);
    x = x0;
    EXPECT_NEAR(-descent.data()[i], (plus - minus) / 2, 1e-8);
  }
}

TEST_P(MuscleTargetTest, TheMinimizerHasNoDescent) {
  const MuscleModel model = SpindleModel(WithAttachments(GetParam()));
  const MuscleTarget target = TargetOf(model, BentPose(0.8), {});
  const Points minimizer = UnconstrainedMinimizer(model, target);
  EXPECT_LT(LinearDescent(model, target, minimizer).cwiseAbs().maxCoeff(),
            1e-9);
}

INSTANTIATE_TEST_SUITE_P(Rows,
                         MuscleTargetTest,
                         ::testing::Values(LaplacianWeights::kArea,
                                           LaplacianWeights::kPaper),
                         [](const auto& of) { return ToString(of.param); });

}  // namespace musclewarp
