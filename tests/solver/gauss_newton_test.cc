// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/gauss_newton.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "musclewarp/solver/volume_constraint.h"
#include "support/invalid_options.h"
#include "support/muscles.h"

namespace musclewarp {
namespace {

// What the method promises of rigid motions, mm.
constexpr double kRigid = 1e-6;

Eigen::Matrix3d Rotation(double angle, const Eigen::Vector3d& axis) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

Points Solve(const MuscleModel& model,
             const ScenePose& pose,
             const PreRotationOptions& pre_rotation = {},
             const GaussNewtonOptions& options = {},
             SolverSummary* summary = nullptr) {
  SolverSummary own;
  if (!summary) summary = &own;
  Points coarse = model.coarse_rest;
  SolveGaussNewton(
      model, TargetOf(model, pose, pre_rotation), options, &coarse, summary);
  return coarse;
}

double FineDistance(const MuscleModel& model,
                    const Points& a,
                    const Points& b) {
  return Product(model.fine_from_coarse, a - b).rowwise().norm().maxCoeff();
}

Points Moved(const Points& points,
             const Eigen::Matrix3d& rotation,
             const Eigen::Vector3d& shift) {
  Points moved = points * rotation.transpose();
  moved.rowwise() += shift.transpose();
  return moved;
}

}  // namespace

TEST(GaussNewtonOptions, DefaultsAreValid) {
  ExpectValid(GaussNewtonOptions());
}

TEST(GaussNewtonOptions, RefuseValuesOutOfRange) {
  ExpectRefused<GaussNewtonOptions>(
      [](auto* options) { options->fine_volume_threshold = -1; },
      "GaussNewtonOptions::fine_volume_threshold is -1, allowed: 0 or above");
  ExpectRefused<GaussNewtonOptions>(
      [](auto* options) { options->max_coarse_iterations = -1; },
      "GaussNewtonOptions::max_coarse_iterations is -1, allowed: 0 or above");
  ExpectRefused<GaussNewtonOptions>(
      [](auto* options) { options->step_threshold = 0; },
      "GaussNewtonOptions::step_threshold is 0, allowed: above 0");
  ExpectRefused<GaussNewtonOptions>(
      [](auto* options) { options->volume_tolerance = NAN; },
      "GaussNewtonOptions::volume_tolerance is nan, allowed: above 0");
  ExpectRefused<GaussNewtonOptions>(
      [](auto* options) { options->max_iterations = 0; },
      "GaussNewtonOptions::max_iterations is 0, allowed: above 0");
  ExpectRefused<GaussNewtonOptions>(
      [](auto* options) { options->polish_threshold = 0.5; },
      "GaussNewtonOptions::polish_threshold is 0.5, allowed: 0 to "
      "polish_start");
  ExpectRefused<GaussNewtonOptions>(
      [](auto* options) { options->step_length.decay = 0; },
      "StepLengthSchedule::decay is 0, allowed: above 0 and at most 1");
}

TEST(GaussNewton, RestInRestOut) {
  const MuscleModel model = SpindleModel();
  SolverSummary summary;
  const Points coarse = Solve(model, ScenePose(), {}, {}, &summary);
  EXPECT_EQ(summary.stop_reason, StopReason::kConverged);
  EXPECT_LT(FineDistance(model, coarse, model.coarse_rest), kRigid);
}

TEST(GaussNewton, ATranslationOfAllLinesTranslatesTheMuscle) {
  const MuscleModel model = SpindleModel();
  const Eigen::Vector3d shift(120, -40, 15);
  const Points coarse =
      Solve(model, RigidPose(Eigen::Matrix3d::Identity(), shift));
  EXPECT_LT(FineDistance(
                model,
                coarse,
                Moved(model.coarse_rest, Eigen::Matrix3d::Identity(), shift)),
            kRigid);
}

TEST(GaussNewton, ARotationOfAllBodiesRotatesTheMuscle) {
  const MuscleModel model = SpindleModel();
  const Eigen::Matrix3d turn = Rotation(1.3, {1, 2, -1});
  const Eigen::Vector3d shift(10, 20, 30);
  const Points coarse = Solve(model, RigidPose(turn, shift));
  EXPECT_LT(FineDistance(model, coarse, Moved(model.coarse_rest, turn, shift)),
            kRigid);
}

// Directions do not show a turn about themselves. Lines given as points alone
// turn the muscle as far as the turn is across the lines: a single straight
// line, turned about an axis across it, determines all.
TEST(GaussNewton, ATurnAcrossTheLineNeedsNoBodies) {
  SceneMuscle muscle = SpindleMuscle();
  muscle.lines = {muscle.lines[1]};
  muscle.lines[0].bodies.clear();
  MuscleModel model = SpindleModel();
  model = PrepareMuscle(muscle,
                        {model.fine_rest, model.fine_triangles},
                        {model.coarse_rest, model.coarse_triangles},
                        {},
                        NoAttachmentRows());
  const Eigen::Matrix3d turn = Rotation(1.3, {1, 2, 0});
  ScenePose pose;
  pose.lines["side"] = Moved(muscle.lines[0].rest, turn, {1, 2, 3});
  const Points coarse = Solve(model, pose);
  EXPECT_LT(
      FineDistance(model, coarse, Moved(model.coarse_rest, turn, {1, 2, 3})),
      kRigid);
}

// A twist about a straight line: without bodies the shape stays as it is, with
// bodies it turns.
TEST(GaussNewton, TwistAboutTheLineIsTakenFromTheBodies) {
  SceneMuscle muscle = SpindleMuscle();
  muscle.lines = {muscle.lines[1]};  // parallel to z
  MuscleModel model = SpindleModel();
  model = PrepareMuscle(muscle,
                        {model.fine_rest, model.fine_triangles},
                        {model.coarse_rest, model.coarse_triangles},
                        {},
                        NoAttachmentRows());
  const Eigen::Matrix3d twist = Rotation(0.7, {0, 0, 1});
  const Eigen::Vector3d on_line(8, 2, 0);
  const ScenePose pose = RigidPose(twist, on_line - twist * on_line);
  PreRotationOptions without;
  without.use_body_twist = false;
  EXPECT_LT(FineDistance(model, Solve(model, pose, without), model.coarse_rest),
            kRigid);
  EXPECT_LT(
      FineDistance(model,
                   Solve(model, pose),
                   Moved(model.coarse_rest, twist, on_line - twist * on_line)),
      kRigid);
}

TEST(GaussNewton, KeepsTheVolumeWhenBent) {
  const MuscleModel model = SpindleModel();
  for (const double angle : {0.3, 0.9, 1.5}) {
    SolverSummary summary;
    const Points coarse = Solve(model, BentPose(angle), {}, {}, &summary);
    EXPECT_EQ(summary.stop_reason, StopReason::kConverged) << angle;
    EXPECT_NEAR(FineVolumeError(model, coarse) / model.rest_volume, 0, 1e-8);
    EXPECT_NEAR(summary.volume_ratio, 1, 1e-8);
  }
}

// The conditions of Lagrange: at the minimum the slope of the energy is a
// multiple of the slope of the volume.
TEST(GaussNewton, EndsWhereEnergyAndVolumeSlopesAreParallel) {
  const MuscleModel model = SpindleModel();
  const ScenePose pose = BentPose(0.9);
  const Points coarse = Solve(model, pose);
  const Points descent =
      LinearDescent(model, TargetOf(model, pose, {}), coarse);
  const Points slope = EvaluateFineVolume(model, coarse).gradient;
  const double multiplier =
      descent.cwiseProduct(slope).sum() / slope.squaredNorm();
  EXPECT_GT(std::abs(multiplier), 0);
  // The last full step was below 1e-4 mm, the next would be far below.
  EXPECT_LT((descent - multiplier * slope).norm(), 1e-4 * descent.norm());
}

TEST(GaussNewton, TakesTheStepsOfThePaper) {
  const MuscleModel model = SpindleModel();
  GaussNewtonOptions options;
  options.polish_threshold = 0;
  SolverSummary summary;
  Solve(model, BentPose(0.9), {}, options, &summary);
  ASSERT_FALSE(summary.history.empty());
  EXPECT_EQ(summary.history.front().alpha, options.step_length.initial_alpha);
  EXPECT_FALSE(summary.history.front().is_fine_volume);
  EXPECT_TRUE(summary.history.back().is_fine_volume);
  for (size_t k = 1; k < summary.history.size(); ++k) {
    const SolverIteration& before = summary.history[k - 1];
    const SolverIteration& now = summary.history[k];
    EXPECT_GE(now.alpha, options.step_length.final_alpha);
    EXPECT_LE(now.alpha, before.alpha);
    // Once |h| is small the fine volume takes over, and stays.
    EXPECT_EQ(
        now.is_fine_volume,
        before.is_fine_volume ||
            before.max_step < before.alpha * options.fine_volume_threshold);
  }
  EXPECT_LT(summary.history.back().max_step, options.step_threshold);
}

TEST(GaussNewton, PolishingOnlySharpensTheResult) {
  const MuscleModel model = SpindleModel();
  GaussNewtonOptions paper;
  paper.polish_threshold = 0;
  paper.step_threshold = 1e-5;
  EXPECT_LT(FineDistance(model,
                         Solve(model, BentPose(0.9), {}, paper),
                         Solve(model, BentPose(0.9))),
            // What damped steps leave: the threshold over the last alpha.
            1e-5 / 0.125);
}

TEST(GaussNewton, SaysWhenItRanOutOfIterations) {
  const MuscleModel model = SpindleModel();
  GaussNewtonOptions options;
  options.max_iterations = 3;
  SolverSummary summary;
  Solve(model, BentPose(0.9), {}, options, &summary);
  EXPECT_EQ(summary.stop_reason, StopReason::kIterationLimit);
  EXPECT_EQ(summary.iterations, 3);
  EXPECT_FALSE(summary.IsSolutionUsable());
}

TEST(GaussNewton, AttachmentsFollowTheirBody) {
  MuscleModelOptions options;
  options.attachment_weight = 3;
  const MuscleModel without = SpindleModel();
  const MuscleModel with = SpindleModel(options);
  const ScenePose pose = BentPose(0.9);
  const auto distance = [&](const MuscleModel& model) {
    const Points fine = Product(model.fine_from_coarse, Solve(model, pose));
    double sum = 0;
    for (Eigen::Index i = 0; i < with.attachment_rest.rows(); ++i) {
      if (with.attachment_of[i] != 1) continue;  // the insertion
      Eigen::Index vertex;
      (with.fine_rest.rowwise() - with.attachment_rest.row(i))
          .rowwise()
          .squaredNorm()
          .minCoeff(&vertex);
      const Points target =
          Moved(with.attachment_rest.row(i),
                pose.bodies.at("femur").topLeftCorner<3, 3>(),
                pose.bodies.at("femur").topRightCorner<3, 1>());
      sum += (fine.row(vertex) - target.row(0)).norm();
    }
    return sum;
  };
  EXPECT_LT(distance(with), 0.5 * distance(without));
}

}  // namespace musclewarp
