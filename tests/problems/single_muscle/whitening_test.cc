// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "problems/single_muscle/whitening.h"

#include <gtest/gtest.h>

#include "support/muscles.h"

namespace musclewarp {

TEST(Whitening, ThereAndBackIsTheIdentity) {
  const MuscleModel model = SpindleModel();
  const Whitening whitening(model, TargetOf(model, BentPose(0.5), {}));
  const Points back = whitening.CoarseFromWhitened(
      whitening.WhitenedFromCoarse(model.coarse_rest));
  EXPECT_LT((back - model.coarse_rest).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(Whitening, TheLinearEnergyIsHalfTheSquaredNorm) {
  const MuscleModel model = SpindleModel();
  const MuscleTarget target = TargetOf(model, BentPose(0.5), {});
  const Whitening whitening(model, target);
  const double least =
      LinearEnergy(model, target, UnconstrainedMinimizer(model, target));
  for (const double scale : {0.9, 1.0, 1.3}) {
    const Points coarse = scale * model.coarse_rest;
    const double energy = LinearEnergy(model, target, coarse);
    EXPECT_NEAR(
        0.5 * whitening.WhitenedFromCoarse(coarse).squaredNorm() + least,
        energy,
        1e-9 * energy);
  }
}

}  // namespace musclewarp
