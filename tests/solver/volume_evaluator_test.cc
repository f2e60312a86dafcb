// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/volume_evaluator.h"

#include <gtest/gtest.h>

#include <vector>

#include "support/meshes.h"
#include "support/muscles.h"

namespace musclewarp {
namespace {

// Every third vertex is held a little off, the fine mesh is shaken.
VertexCorrections SomeCorrections(const MuscleModel& model) {
  VertexCorrections corrections;
  corrections.fine_offset =
      RandomPoints(static_cast<int>(model.fine_rest.rows()), 1);
  std::vector<char> coarse(model.coarse_rest.rows(), 0);
  for (size_t i = 0; i < coarse.size(); i += 3) coarse[i] = 1;
  std::vector<char> fine(model.fine_rest.rows(), 0);
  for (size_t i = 0; i < fine.size(); i += 3) fine[i] = 1;
  corrections.held_coarse =
      HeldVertices::Of(model.coarse_rest.array() + 0.5, coarse);
  corrections.held_fine = HeldVertices::Of(model.fine_rest.array() - 0.5, fine);
  return corrections;
}

// Of central differences, mm: the volume is cubic in each coordinate, so that
// they err by the square of this.
constexpr double kStep = 1e-4;

// Volumes of 1e4 mm^3 are rounded by 1e-12 of that; over the step, mm^2.
constexpr double kDerivative = 1e-5;

}  // namespace

TEST(VolumeEvaluator, AnswersAsAFreshOneWouldWhateverWasAskedBefore) {
  const MuscleModel model = SpindleModel();
  const VertexCorrections corrections = SomeCorrections(model);
  VolumeEvaluator one(model, &corrections);
  const Points a = model.coarse_rest + RandomPoints(162, 2);
  const Points b = model.coarse_rest + RandomPoints(162, 3);
  for (const Points* x : {&a, &b, &b, &a, &a}) {
    VolumeEvaluator fresh(model, &corrections);
    EXPECT_EQ(one.Error(*x), fresh.Error(*x));
    EXPECT_EQ(one.Gradient(*x), fresh.Gradient(*x));
  }
  one.SetMesh(VolumeMesh::kCoarse);
  VolumeEvaluator coarse(model, &corrections);
  coarse.SetMesh(VolumeMesh::kCoarse);
  EXPECT_EQ(one.Gradient(a), coarse.Gradient(a));
  EXPECT_NE(one.Error(a), VolumeEvaluator(model, &corrections).Error(a));
}

TEST(VolumeEvaluator, ReusesTheGradientOfAPlaceNearby) {
  const MuscleModel model = SpindleModel();
  VolumeEvaluator volume(model, nullptr);
  volume.ReuseGradientWithin(0.1);
  const Points& here = model.coarse_rest;
  Points near = here, far = here;
  near(3, 1) += 0.09;
  far(3, 1) += 0.11;
  const auto fresh = [&](const Points& coarse) {
    return Points(VolumeEvaluator(model, nullptr).Gradient(coarse));
  };
  EXPECT_EQ(volume.Gradient(here), fresh(here));
  EXPECT_EQ(volume.Gradient(near), fresh(here));
  // The error is always that of the place.
  EXPECT_EQ(volume.Error(near), VolumeEvaluator(model, nullptr).Error(near));
  EXPECT_EQ(volume.Gradient(far), fresh(far));
  EXPECT_NE(fresh(far), fresh(here));
  volume.Forget();
  EXPECT_EQ(volume.Gradient(near), fresh(near));
}

TEST(VolumeEvaluator, SeesChangedCorrectionsWhenTold) {
  const MuscleModel model = SpindleModel();
  VertexCorrections corrections;
  VolumeEvaluator volume(model, &corrections);
  const double before = volume.Error(model.coarse_rest);
  corrections = SomeCorrections(model);
  volume.Forget();
  EXPECT_EQ(volume.Error(model.coarse_rest),
            VolumeEvaluator(model, &corrections).Error(model.coarse_rest));
  EXPECT_NE(volume.Error(model.coarse_rest), before);
}

TEST(VolumeEvaluator, AnOffsetByTheShapeItselfMakesTheVolumeEightfold) {
  const MuscleModel model = SpindleModel();
  VertexCorrections corrections;
  corrections.fine_offset = model.fine_rest;
  VolumeEvaluator volume(model, &corrections);
  // The coarse mesh reproduces the fine one to 1e-10 of its size.
  constexpr double kReproduced = 1e-8;
  EXPECT_NEAR(
      volume.Error(model.coarse_rest) / model.rest_volume, 7, kReproduced);
}

TEST(VolumeEvaluator, HasTheGradientOfItsError) {
  const MuscleModel model = SpindleModel();
  const VertexCorrections corrections = SomeCorrections(model);
  const Points x = model.coarse_rest + RandomPoints(162, 4);
  for (const VolumeMesh mesh : {VolumeMesh::kCoarse, VolumeMesh::kFine}) {
    VolumeEvaluator volume(model, &corrections);
    volume.SetMesh(mesh);
    const Points gradient = volume.Gradient(x);
    for (const int v : {0, 1, 2, 50, 100, 161}) {
      for (int k = 0; k < 3; ++k) {
        Points moved = x;
        moved(v, k) += kStep;
        const double plus = volume.Error(moved);
        moved(v, k) -= 2 * kStep;
        const double minus = volume.Error(moved);
        EXPECT_NEAR(gradient(v, k), (plus - minus) / (2 * kStep), kDerivative);
      }
    }
    for (const int v : corrections.held_coarse.vertices) {
      EXPECT_TRUE(gradient.row(v).isZero(0));
    }
  }
}

}  // namespace musclewarp
