// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "problems/single_muscle/coordinates_term.h"

#include <gtest/gtest.h>

#include <memory>

#include "problems/single_muscle/term_checks.h"

namespace musclewarp {

namespace {

Eigen::RowVectorXd Coordinates() { return Eigen::RowVector3d(0.5, 0.25, 0.25); }

}  // namespace

TEST(CoordinatesTerm, IsZeroIfThePointIsAtTheTarget) {
  const Points x = RandomPoints(3);
  const Eigen::RowVector3d point = Coordinates() * x;
  const std::unique_ptr<ceres::CostFunction> term(
      CoordinatesTerm::Create(Coordinates(), point.data()));
  // Rounding of coordinates of size 5.
  EXPECT_LT(Residuals(*term, x).norm(), 1e-14);
}

TEST(CoordinatesTerm, IsThePointMinusTheTarget) {
  Points x(3, 3);
  x << 2, 0, 0, 0, 4, 0, 0, 0, 8;
  const double target[3] = {0, -1, -1};
  const std::unique_ptr<ceres::CostFunction> term(
      CoordinatesTerm::Create(Coordinates(), target));
  // (1, 1, 2) - target
  EXPECT_TRUE(Residuals(*term, x).isApprox(Eigen::Vector3d(1, 2, 3)));
}

TEST(CoordinatesTerm, HasTheRightDerivative) {
  const double target[3] = {1, 2, 3};
  const std::unique_ptr<ceres::CostFunction> term(
      CoordinatesTerm::Create(Coordinates(), target));
  ExpectRightDerivative(*term, RandomPoints(3));
}

}  // namespace musclewarp
