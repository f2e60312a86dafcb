// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/volume_restoration.h"

#include <gtest/gtest.h>

#include <cmath>

#include "musclewarp/mesh/measures.h"
#include "musclewarp/solver/volume_constraint.h"
#include "support/muscles.h"

namespace musclewarp {
namespace {

// What RestoreVolume promises, relative.
constexpr double kVolume = 1e-10;

// Of W X + offset with coordinates of size 100, mm.
constexpr double kOffsetRounding = 1e-12;

double VolumeRatio(const MuscleModel& model, const MuscleState& state) {
  return SignedVolume(FinePoints(model, state), model.fine_triangles) /
         model.rest_volume;
}

// Marks every third of `count`.
std::vector<char> EveryThird(Eigen::Index count) {
  std::vector<char> marked(count, 0);
  for (Eigen::Index i = 0; i < count; i += 3) marked[i] = 1;
  return marked;
}

}  // namespace

TEST(RestoreVolume, RestoresTheVolumeOfAScaledMuscle) {
  const MuscleModel model = SpindleModel();
  for (const double scale : {0.9, 1.1}) {
    MuscleState state{scale * model.coarse_rest, {}};
    const double left = RestoreVolume(model, &state);
    EXPECT_LT(std::abs(left), kVolume);
    EXPECT_NEAR(VolumeRatio(model, state), 1, kVolume);
  }
}

TEST(RestoreVolume, LeavesAMuscleOfTheRightVolume) {
  const MuscleModel model = SpindleModel();
  MuscleState state{model.coarse_rest, {}};
  EXPECT_LT(std::abs(RestoreVolume(model, &state)), kVolume);
  EXPECT_EQ(state.coarse, model.coarse_rest);
  EXPECT_EQ(state.corrections.fine_offset.rows(), 0);
}

TEST(RestoreVolume, ChangesTheShapeAsLittleAsPossible) {
  const MuscleModel model = SpindleModel();
  MuscleState state{1.0001 * model.coarse_rest, {}};
  const Points start = state.coarse;
  RestoreVolume(model, &state);
  const Points change = state.coarse - start;
  // At the minimum of 1/2 dX . A dX for a given change of volume, A dX is a
  // multiple of the gradient of the volume (the conditions of Lagrange).
  const Points slope = model.normal_matrix.reconstructedMatrix() * change;
  const Points gradient = EvaluateFineVolume(model, start).gradient;
  const double multiplier =
      slope.cwiseProduct(gradient).sum() / gradient.squaredNorm();
  EXPECT_LT(multiplier, 0);
  // The error is 3e-4, and so is the second step relative to the first.
  EXPECT_LT((slope - multiplier * gradient).norm(), 1e-3 * slope.norm());
}

TEST(RestoreVolume, LeavesHeldVerticesWhereTheyAreHeld) {
  const MuscleModel model = SpindleModel();
  MuscleState state{1.02 * model.coarse_rest, {}};
  const Points start = state.coarse;
  VertexCorrections& corrections = state.corrections;
  corrections.held_coarse = HeldVertices::Of(start, EveryThird(start.rows()));
  // The fine ones are held half a millimetre from where they would be.
  const Points fine = FinePoints(model, state).array() + 0.5;
  corrections.held_fine = HeldVertices::Of(fine, EveryThird(fine.rows()));
  EXPECT_LT(std::abs(RestoreVolume(model, &state)), kVolume);
  const Points after = FinePoints(model, state);
  const HeldVertices& held = state.corrections.held_fine;
  for (size_t k = 0; k < held.vertices.size(); ++k) {
    EXPECT_LT((after.row(held.vertices[k]) - held.positions.row(k)).norm(),
              kOffsetRounding);
  }
}

TEST(RestoreVolume, GivesUpIfAllVerticesAreHeld) {
  const MuscleModel model = SpindleModel();
  MuscleState state{1.1 * model.coarse_rest, {}};
  const Points start = state.coarse;
  state.corrections.held_fine = HeldVertices::Of(
      FinePoints(model, state), std::vector<char>(model.fine_rest.rows(), 1));
  EXPECT_NEAR(RestoreVolume(model, &state), 1.1 * 1.1 * 1.1 - 1, kVolume);
  EXPECT_EQ(state.coarse, start);
}

}  // namespace musclewarp
