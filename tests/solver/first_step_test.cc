// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/first_step.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "support/muscles.h"

namespace musclewarp {
namespace {

TEST(FirstStep, IsZeroAtAMinimum) {
  const MuscleModel model = SpindleModel();
  const MuscleTarget target = TargetOf(model, BentPose(0.5), {});
  VolumeEvaluator volume(model, nullptr);
  const Points minimum = SolvedTightly(model, target);
  const FirstStep first = FirstStepFrom(model, target, minimum, &volume);
  // The solver ends within 1e-10 mm.
  EXPECT_LT(first.length, 1e-8);
  EXPECT_NE(first.multiplier, 0);
  // The forces of the energy and of the volume balance each other.
  const Points left = LinearDescent(model, target, minimum) -
                      first.multiplier * volume.Gradient(minimum);
  EXPECT_LT(left.norm(), 1e-6 * LinearDescent(model, target, minimum).norm());
}

TEST(FirstStep, LeadsNearTheMinimumFromClose) {
  const MuscleModel model = SpindleModel();
  const MuscleTarget target = TargetOf(model, BentPose(0.5), {});
  const Points minimum = SolvedTightly(model, target);
  const Points near = minimum + 0.1 * Points::Random(minimum.rows(), 3);
  VolumeEvaluator volume(model, nullptr);
  const FirstStep at_minimum = FirstStepFrom(model, target, minimum, &volume);
  const FirstStep first = FirstStepFrom(model, target, near, &volume);
  EXPECT_NEAR(first.length, (near - minimum).rowwise().norm().maxCoeff(), 0.02);
  EXPECT_NEAR(first.multiplier,
              at_minimum.multiplier,
              0.5 * std::abs(at_minimum.multiplier));
}

TEST(FirstStep, IsTheSameForBodiesThatMovedAsOne) {
  const MuscleModel model = SpindleModel();
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1).normalized())
          .toRotationMatrix();
  const Eigen::Vector3d shift(30, -20, 50);
  const Points beside =
      model.coarse_rest + 0.1 * Points::Random(model.coarse_rest.rows(), 3);
  VolumeEvaluator volume(model, nullptr);
  const FirstStep at_rest = FirstStepFrom(
      model,
      TargetOf(model, RigidPose(Eigen::Matrix3d::Identity(), {0, 0, 0}), {}),
      beside,
      &volume);
  const Points moved =
      (beside * rotation.transpose()).rowwise() + shift.transpose();
  const FirstStep carried = FirstStepFrom(
      model, TargetOf(model, RigidPose(rotation, shift), {}), moved, &volume);
  EXPECT_NEAR(carried.length, at_rest.length, 1e-6);
  EXPECT_NEAR(carried.multiplier, at_rest.multiplier, 1e-6);
}

}  // namespace
}  // namespace musclewarp
