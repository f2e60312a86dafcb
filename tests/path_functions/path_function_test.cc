// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/path_functions/path_function.h"

#include <gtest/gtest.h>

#include <cmath>

#include "musclewarp/base/random_draws.h"

namespace musclewarp {
namespace {

// 200 - 40 x + 5 x^2 y - 3 y^3, in -1 to 1 times -0.5 to 0.5.
PathFunction Cubic() {
  PathFunction path;
  path.coordinates = {0, 2};
  path.exponents.resize(4, 2);
  path.exponents << 0, 0, 1, 0, 2, 1, 0, 3;
  path.coefficients.resize(4);
  path.coefficients << 200, -40, 5, -3;
  path.low = Eigen::Vector2d(-1, -0.5);
  path.high = Eigen::Vector2d(1, 0.5);
  return path;
}

TEST(PathFunction, IsItsPolynomialInside) {
  const double x = 0.3, y = -0.4;
  const PathValue value = Evaluate(Cubic(), Eigen::Vector2d(x, y));
  EXPECT_TRUE(value.is_inside_range);
  EXPECT_DOUBLE_EQ(value.length, 200 - 40 * x + 5 * x * x * y - 3 * y * y * y);
  EXPECT_DOUBLE_EQ(value.arms[0], 40 - 10 * x * y);
  EXPECT_DOUBLE_EQ(value.arms[1], -5 * x * x + 9 * y * y);
}

TEST(PathFunction, GoesOnLinearlyOutside) {
  const Eigen::Vector2d edge(1, 0.2);
  const PathValue at_edge = Evaluate(Cubic(), edge);
  const PathValue beyond = Evaluate(Cubic(), Eigen::Vector2d(1.7, 0.2));
  EXPECT_FALSE(beyond.is_inside_range);
  EXPECT_DOUBLE_EQ(beyond.length, at_edge.length - 0.7 * at_edge.arms[0]);
  EXPECT_DOUBLE_EQ(beyond.arms[0], at_edge.arms[0]);
}

// Arms are the derivatives of the length, inside, outside and across the edges:
// that is what keeps a simulation's energy.
TEST(PathFunction, ArmsAreDerivativesEverywhere) {
  const PathFunction path = Cubic();
  RandomDraws draws(1);
  constexpr double kStep = 1e-5;
  for (int i = 0; i < 500; ++i) {
    Eigen::Vector2d at;
    at[0] = draws.Uniform(-2, 2);
    at[1] = draws.Uniform(-1, 1);
    const PathValue value = Evaluate(path, at);
    for (int k = 0; k < 2; ++k) {
      Eigen::Vector2d aside = at;
      aside[k] += kStep;
      const double above = Evaluate(path, aside).length;
      aside[k] -= 2 * kStep;
      const double below = Evaluate(path, aside).length;
      // The second derivative jumps at an edge, by at most 30: half a step of
      // it is the error of a central difference there.
      EXPECT_NEAR(-(above - below) / (2 * kStep), value.arms[k], 2e-4);
    }
  }
}

// Also where several coordinates leave the range.
TEST(PathFunction, ArmsAreContinuous) {
  const PathFunction path = Cubic();
  const Eigen::VectorXd inside = Evaluate(path, path.high).arms;
  const Eigen::Vector2d corner = path.high + Eigen::Vector2d(0.4, 0);
  constexpr double kNear = 1e-9;
  const Eigen::Vector2d aside(0, kNear);
  const Eigen::VectorXd before = Evaluate(path, corner - aside).arms;
  const Eigen::VectorXd behind = Evaluate(path, corner + aside).arms;
  // Arms change by less than 100 mm per rad.
  EXPECT_LT((before - behind).norm(), 200 * kNear);
  EXPECT_GT((before - inside).norm(), 1);
}

}  // namespace
}  // namespace musclewarp
