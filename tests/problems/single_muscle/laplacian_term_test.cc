// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "problems/single_muscle/laplacian_term.h"

#include <gtest/gtest.h>

#include <memory>

#include "problems/single_muscle/term_checks.h"

namespace musclewarp {

TEST(LaplacianTerm, IsZeroIfTheLaplacianCoordinateIsDelta) {
  const Points x = RandomPoints(3);
  const Eigen::RowVector3d delta =
      0.25 * (x.row(1) - x.row(0)) + 0.75 * (x.row(2) - x.row(0));
  const std::unique_ptr<ceres::CostFunction> term(
      LaplacianTerm::Create({0.25, 0.75}, delta.data()));
  // Rounding of coordinates of size 5.
  EXPECT_LT(Residuals(*term, x).norm(), 1e-14);
}

TEST(LaplacianTerm, IsTheWeightedSumMinusDelta) {
  Points x(3, 3);
  x << 1, 1, 1, 3, 1, 1, 1, 5, 1;
  const double delta[3] = {0.5, 0, 7};
  const std::unique_ptr<ceres::CostFunction> term(
      LaplacianTerm::Create({0.25, 0.75}, delta));
  // 0.25 (2, 0, 0) + 0.75 (0, 4, 0) - delta
  EXPECT_TRUE(Residuals(*term, x).isApprox(Eigen::Vector3d(0, 3, -7)));
}

TEST(LaplacianTerm, HasTheRightDerivative) {
  const double delta[3] = {0.5, 0, 7};
  const std::unique_ptr<ceres::CostFunction> term(
      LaplacianTerm::Create({0.25, 0.75}, delta));
  ExpectRightDerivative(*term, RandomPoints(3));
}

}  // namespace musclewarp
