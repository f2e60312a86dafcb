// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ceres/gradient_checker.h>
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// What tests of residual terms have in common. The parameter blocks of a term
// are the rows of `parameters` (#blocks x 3).

inline std::vector<const double*> TermBlocks(const Points& parameters) {
  std::vector<const double*> blocks;
  for (Eigen::Index i = 0; i < parameters.rows(); ++i) {
    blocks.push_back(parameters.data() + 3 * i);
  }
  return blocks;
}

inline Eigen::VectorXd Residuals(const ceres::CostFunction& term,
                                 const Points& parameters) {
  Eigen::VectorXd residuals(term.num_residuals());
  const std::vector<const double*> blocks = TermBlocks(parameters);
  EXPECT_TRUE(term.Evaluate(blocks.data(), residuals.data(), nullptr));
  return residuals;
}

// Expects that the Jacobian agrees with differences.
inline void ExpectRightDerivative(const ceres::CostFunction& term,
                                  const Points& parameters) {
  // Relative; the numeric derivatives (Ridders) are good to 1e-9.
  constexpr double kDerivative = 1e-7;
  const ceres::NumericDiffOptions options;
  ceres::GradientChecker checker(
      &term,
      static_cast<const std::vector<const ceres::Manifold*>*>(nullptr),
      options);
  ceres::GradientChecker::ProbeResults results;
  const std::vector<const double*> blocks = TermBlocks(parameters);
  EXPECT_TRUE(checker.Probe(blocks.data(), kDerivative, &results))
      << results.error_log;
}

// Coordinates between -5 and 5, the same at every call.
inline Points RandomPoints(int count) {
  std::mt19937 engine(5);
  Points points(count, 3);
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    points.data()[i] = 10 * (engine() / 4294967296.0) - 5;
  }
  return points;
}

}  // namespace musclewarp
