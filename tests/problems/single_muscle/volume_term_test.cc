// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "problems/single_muscle/volume_term.h"

#include <gtest/gtest.h>

#include <vector>

#include "problems/single_muscle/term_checks.h"
#include "problems/single_muscle/whitening.h"
#include "support/muscles.h"

namespace musclewarp {

namespace {

// Of volumes of 1e4 mm^3, over the area and times the root of the penalty.
constexpr double kVolumeRounding = 1e-9;

}  // namespace

TEST(VolumeTerm, IsZeroAtRestAndAtTheTarget) {
  const MuscleModel model = SpindleModel();
  HardConstraint constraint;
  constraint.penalty = 100;
  VolumeEvaluator volume(model, nullptr);
  const MuscleUnknowns unknowns(
      model, MuscleTarget(), MuscleFormulation::kBlocks, model.coarse_rest);
  const VolumeTerm term(&unknowns, &volume, &constraint);
  EXPECT_NEAR(Residuals(term, model.coarse_rest)[0], 0, kVolumeRounding);
  // Twice the size has eight times the volume.
  constraint.target = 7 * model.rest_volume / model.rest_area;
  EXPECT_NEAR(Residuals(term, 2 * model.coarse_rest)[0], 0, kVolumeRounding);
}

TEST(VolumeTerm, IsTheErrorAsAThicknessPlusTheMultiplier) {
  const MuscleModel model = SpindleModel();
  HardConstraint constraint;
  constraint.penalty = 100;
  VolumeEvaluator volume(model, nullptr);
  const MuscleUnknowns unknowns(
      model, MuscleTarget(), MuscleFormulation::kBlocks, model.coarse_rest);
  const VolumeTerm term(&unknowns, &volume, &constraint);
  // Twice the size has eight times the volume.
  EXPECT_NEAR(Residuals(term, 2 * model.coarse_rest)[0],
              10 * 7 * model.rest_volume / model.rest_area,
              kVolumeRounding);
  constraint.multiplier = 30;
  EXPECT_NEAR(Residuals(term, model.coarse_rest)[0], 3, kVolumeRounding);
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

TEST(VolumeTerm, HasTheRightDerivativeWithHeldVertices) {
  const MuscleModel model = SpindleModel();
  HardConstraint constraint;
  constraint.penalty = 100;
  const Points shaken =
      model.coarse_rest + RandomPoints(model.coarse_rest.rows());
  std::vector<char> is_held(shaken.rows(), 0);
  for (size_t i = 0; i < is_held.size(); i += 3) is_held[i] = 1;
  VertexCorrections corrections;
  corrections.held_coarse = HeldVertices::Of(shaken, is_held);
  VolumeEvaluator volume(model, &corrections);
  const MuscleUnknowns unknowns(
      model, MuscleTarget(), MuscleFormulation::kBlocks, shaken);
  const VolumeTerm term(&unknowns, &volume, &constraint);
  ExpectRightDerivative(term, shaken);
  // Moving a held vertex changes nothing.
  Points moved = shaken;
  moved.row(0) *= 2;
  EXPECT_EQ(Residuals(term, moved), Residuals(term, shaken));
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
