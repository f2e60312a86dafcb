// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/path_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/input_errors.h"

namespace musclewarp {
namespace {

PathSample SampleOf(const MultivariatePolynomial& length,
                    const Eigen::VectorXd& at) {
  PathSample sample{at, PolynomialValue(length, at), at};
  for (int k = 0; k < at.size(); ++k) {
    sample.arms[k] = -PolynomialDerivative(length, k, at);
  }
  return sample;
}

MultivariatePolynomial Cubic() {
  MultivariatePolynomial cubic{2, 3, Eigen::VectorXd(10)};
  cubic.coefficients << 200, 30, -4, 5, -20, 6, 7, 8, -9, 3;
  return cubic;
}

TEST(PathFit, RecoversAPolynomial) {
  std::vector<PathSample> samples;
  for (double x = -0.5; x < 1.3; x += 0.3) {
    for (double y = -0.4; y < 0.5; y += 0.2) {
      samples.push_back(SampleOf(Cubic(), Eigen::Vector2d(x, y)));
    }
  }
  PathFitOptions options;
  options.max_length_error = options.max_arm_error = 1e-9;
  const PathFit fit = FitPath("line", samples, options);
  EXPECT_TRUE(fit.within_bounds);
  EXPECT_EQ(fit.length.order, 3);
  EXPECT_LT((fit.length.coefficients - Cubic().coefficients).norm(), 1e-9);
}

// Only x moves: y enters by its arms, and so linearly.
TEST(PathFit, CoordinateThatDoesNotVaryEntersLinearly) {
  std::vector<PathSample> samples;
  for (double x = -0.5; x < 1.3; x += 0.1) {
    samples.push_back(SampleOf(Cubic(), Eigen::Vector2d(x, 0.2)));
  }
  PathFitOptions options;
  options.max_length_error = options.max_arm_error = 1e-9;
  const PathFit fit = FitPath("line", samples, options);
  EXPECT_TRUE(fit.within_bounds);
  const Eigen::Vector2d held(0.37, 0.2), away(0.37, 0.5);
  const double arm = -PolynomialDerivative(Cubic(), 1, held);
  EXPECT_NEAR(PolynomialValue(fit.length, away),
              PolynomialValue(Cubic(), held) - arm * (away - held)[1],
              1e-9);
}

TEST(PathFit, LeavesOutCoordinatesWithoutArms) {
  std::vector<PathSample> samples;
  for (double x = -0.5; x < 0.6; x += 0.1) {
    samples.push_back(
        {Eigen::Vector2d(1, x), 100 + 20 * x, Eigen::Vector2d(0, -20)});
  }
  const PathFit fit = FitPath("line", samples, PathFitOptions());
  EXPECT_EQ(fit.coordinates, std::vector<int>{1});
  EXPECT_EQ(fit.length.order, 1);
  EXPECT_LT(fit.errors.length_max, 1e-9);
  for (PathSample& sample : samples) sample.arms.setZero();
  ExpectInputError([&] { FitPath("line", samples, PathFitOptions()); },
                   {"line", "0 coordinates"});
}

// A jump of 10 mm is no polynomial; half of it is the least error at it.
TEST(PathFit, SaysThatErrorsExceedTheBounds) {
  std::vector<PathSample> samples;
  for (int i = 0; i < 20; ++i) {
    samples.push_back({Eigen::VectorXd::Constant(1, 0.01 * i),
                       i < 10 ? 100. : 110.,
                       Eigen::VectorXd::Constant(1, 5)});
  }
  const PathFit fit = FitPath("line", samples, PathFitOptions());
  EXPECT_FALSE(fit.within_bounds);
  EXPECT_GT(std::max(2 * fit.errors.length_max, fit.errors.arm_max), 1);
}

}  // namespace
}  // namespace musclewarp
