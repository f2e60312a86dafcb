// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/gauss_newton_step.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "musclewarp/solver/muscle_target.h"
#include "musclewarp/solver/volume_constraint.h"
#include "support/muscles.h"

namespace musclewarp {
namespace {

// Of sums of N products, relative to their size.
constexpr double kStepRounding = 1e-9;

Points Shaken(const Points& points, double by) {
  std::mt19937 engine(7);
  Points shaken = points;
  for (Eigen::Index i = 0; i < shaken.size(); ++i) {
    shaken.data()[i] += by * (engine() / 2147483648.0 - 1);
  }
  return shaken;
}

// A bent spindle at a place that is neither rest nor the solution.
struct Place {
  MuscleModel model = SpindleModel();
  MuscleTarget target = TargetOf(model, BentPose(0.6), {});
  Points minimizer = UnconstrainedMinimizer(model, target);
  MuscleState state{Shaken(1.05 * model.coarse_rest, 1), {}};
};

}  // namespace

TEST(GaussNewtonStep, IsNoneAtRest) {
  const MuscleModel model = SpindleModel();
  const MuscleState rest{model.coarse_rest, {}};
  for (const bool is_fine : {false, true}) {
    const GaussNewtonStep step =
        ComputeGaussNewtonStep(model, model.coarse_rest, rest, 0.5, is_fine);
    ASSERT_TRUE(step.is_finite);
    // Rounding of the volume, over the area, mm.
    EXPECT_LT(step.h.cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST(GaussNewtonStep, ShortenedCorrectsTheVolumeToFirstOrder) {
  const Place at;
  for (const double alpha : {0.125, 0.5, 1.0}) {
    for (const bool is_fine : {false, true}) {
      const GaussNewtonStep step = ComputeGaussNewtonStep(
          at.model, at.minimizer, at.state, alpha, is_fine);
      const FineVolume volume =
          is_fine ? EvaluateFineVolume(at.model, at.state.coarse)
                  : EvaluateCoarseVolume(at.model, at.state.coarse);
      ASSERT_TRUE(step.is_finite);
      EXPECT_EQ(step.volume_error, volume.error);
      // J_g (alpha h) = -dV
      EXPECT_NEAR(alpha * volume.gradient.cwiseProduct(step.h).sum(),
                  -volume.error,
                  kStepRounding * std::abs(volume.error));
    }
  }
}

TEST(GaussNewtonStep, LeavesAResidualAlongTheVolumeGradient) {
  // A h + J_f^T f is -lambda J_g^T: in all other directions the step goes to
  // the minimum of the linear energy.
  const Place at;
  const GaussNewtonStep step = ComputeGaussNewtonStep(
      at.model, at.minimizer, at.state, 0.5, /*is_fine_volume=*/true);
  const Points residual =
      at.model.normal_matrix.reconstructedMatrix() * step.h -
      LinearDescent(at.model, at.target, at.state.coarse);
  const Points gradient =
      EvaluateFineVolume(at.model, at.state.coarse).gradient;
  const double lambda =
      -residual.cwiseProduct(gradient).sum() / gradient.squaredNorm();
  EXPECT_NE(lambda, 0);
  EXPECT_LT((residual + lambda * gradient).norm(),
            kStepRounding * residual.norm());
}

TEST(GaussNewtonStep, HeldVerticesAreNotMovedByTheVolumeAlone) {
  // With the minimiser at the state only the volume asks for a step, along
  // A^-1 J_g^T. J_g has no rows of held vertices, so A h has none.
  Place at;
  std::vector<char> is_held(at.state.coarse.rows(), 0);
  for (size_t i = 0; i < is_held.size(); i += 3) is_held[i] = 1;
  at.state.corrections.held_coarse = HeldVertices::Of(at.state.coarse, is_held);
  const GaussNewtonStep step =
      ComputeGaussNewtonStep(at.model, at.state.coarse, at.state, 1, true);
  ASSERT_TRUE(step.is_finite);
  const Points forces = at.model.normal_matrix.reconstructedMatrix() * step.h;
  for (size_t i = 0; i < is_held.size(); ++i) {
    if (is_held[i]) {
      EXPECT_LT(forces.row(i).norm(), kStepRounding * forces.norm());
    }
  }
  EXPECT_GT(step.h.norm(), 0);
}

TEST(GaussNewtonStep, SaysThatTheVolumeGradientVanished) {
  Place at;
  at.state.corrections.held_coarse = HeldVertices::Of(
      at.state.coarse, std::vector<char>(at.state.coarse.rows(), 1));
  EXPECT_FALSE(ComputeGaussNewtonStep(at.model, at.minimizer, at.state, 1, true)
                   .is_finite);
}

TEST(GaussNewtonStep, OneSidedRowsThatAreNotActiveChangeNothing) {
  const Place at;
  const Points fine = FinePoints(at.model, at.state);
  for (const double depth : {-1.0, 1.0}) {
    const OneSidedRows rows =
        OneSidedRowsOf({{7, {{1, 0, 0}, fine(7, 0) + depth}}}, 0.5);
    OneSidedSystem system(at.model, rows);
    const Points without =
        ComputeGaussNewtonStep(at.model, at.minimizer, at.state, 0.5, true).h;
    const Points with =
        ComputeGaussNewtonStep(
            at.model, at.minimizer, at.state, 0.5, true, &system)
            .h;
    if (depth < 0) {
      EXPECT_EQ(with, without);
    } else {
      // The row pulls its vertex along x.
      const Eigen::RowVector3d pull =
          RowsOf(at.model.fine_from_coarse, {7}) * (with - without);
      EXPECT_GT(pull[0], 0);
    }
  }
}

}  // namespace musclewarp
