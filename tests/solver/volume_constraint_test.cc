// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/volume_constraint.h"

#include <gtest/gtest.h>

#include "support/muscles.h"

namespace musclewarp {

TEST(VolumeConstraint, IsZeroAtRest) {
  const MuscleModel model = SpindleModel();
  // Rounding of W X_0, 1e-13 mm, over the area.
  EXPECT_NEAR(
      FineVolumeError(model, model.coarse_rest), 0, 1e-12 * model.rest_volume);
}

TEST(VolumeConstraint, GradientIsTheNumericDerivative) {
  const MuscleModel model = SpindleModel();
  Points coarse = 1.1 * model.coarse_rest;
  const FineVolume volume = EvaluateFineVolume(model, coarse);
  EXPECT_DOUBLE_EQ(volume.error, FineVolumeError(model, coarse));
  for (Eigen::Index i = 0; i < coarse.size(); i += 7) {
    double& x = coarse.data()[i];
    const double x0 = x;
    // Cubic in one coordinate: central differences err with the square of h.
    const double h = 1e-3;
    x = x0 + h;
    const double plus = FineVolumeError(model, coarse);
    x = x0 - h;
    const double minus = FineVolumeError(model, coarse);
    x = x0;
    EXPECT_NEAR(volume.gradient.data()[i], (plus - minus) / (2 * h), 1e-5);
  }
}

}  // namespace musclewarp
