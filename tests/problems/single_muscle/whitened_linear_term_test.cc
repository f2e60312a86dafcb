// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "problems/single_muscle/whitened_linear_term.h"

#include <gtest/gtest.h>

#include <memory>

#include "problems/single_muscle/term_checks.h"

namespace musclewarp {

TEST(WhitenedLinearTerm, IsItsUnknown) {
  const std::unique_ptr<ceres::CostFunction> term(WhitenedLinearTerm::Create());
  const Points y = RandomPoints(1);
  EXPECT_EQ(Residuals(*term, y), Eigen::VectorXd(y.row(0).transpose()));
  EXPECT_EQ(Residuals(*term, Points::Zero(1, 3)), Eigen::Vector3d::Zero());
}

TEST(WhitenedLinearTerm, HasTheRightDerivative) {
  const std::unique_ptr<ceres::CostFunction> term(WhitenedLinearTerm::Create());
  ExpectRightDerivative(*term, RandomPoints(1));
}

}  // namespace musclewarp
