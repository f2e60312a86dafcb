// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/path_functions/path_fit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "musclewarp/base/random_draws.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;

// What the penalty on terms of degree 3 changes, of coefficients of 10 mm.
constexpr double kPenalised = 5e-3;

// 200 + 30 y - 20 x + 6 x y + 7 x y^2 - 9 x^2 + 3 x^3 mm.
PathSample CubicAt(double x, double y) {
  PathSample sample;
  sample.coordinates = Eigen::Vector2d(x, y);
  sample.length = 200 + 30 * y - 20 * x + 6 * x * y + 7 * x * y * y -
                  9 * x * x + 3 * x * x * x;
  sample.arms = -Eigen::Vector2d(-20 + 6 * y + 7 * y * y - 18 * x + 9 * x * x,
                                 30 + 6 * x + 14 * x * y);
  return sample;
}

std::vector<PathSample> CubicSamples(int count, double noise = 0) {
  RandomDraws draws(1);
  std::vector<PathSample> samples;
  for (int i = 0; i < count; ++i) {
    const double x = draws.Uniform(-0.5, 1.3);
    const double y = draws.Uniform(-0.4, 0.6);
    PathSample sample = CubicAt(x, y);
    sample.length += draws.Uniform(-noise, noise);
    for (int k = 0; k < 2; ++k) sample.arms[k] += draws.Uniform(-noise, noise);
    samples.push_back(sample);
  }
  return samples;
}

TEST(PathFit, FindsThePolynomialAndItsTerms) {
  const PathFit fit = FitPath(CubicSamples(60), {0, 1});
  EXPECT_THAT(fit.path.coordinates, ElementsAre(0, 1));
  EXPECT_LT(fit.held_back.length.largest, kPenalised);
  EXPECT_LT(fit.held_back.arm.largest, 5 * kPenalised);
  RandomDraws draws(2);
  for (int i = 0; i < 100; ++i) {
    const double x = draws.Uniform(-0.4, 1.2);
    const double y = draws.Uniform(-0.3, 0.5);
    const PathSample expected = CubicAt(x, y);
    const PathValue value = Evaluate(fit.path, expected.coordinates);
    EXPECT_NEAR(value.length, expected.length, kPenalised);
    EXPECT_LT((value.arms - expected.arms).norm(), 5 * kPenalised);
  }
}

// Law: a term is found although none of the terms below it explains anything.
TEST(PathFit, FindsATermThatStandsAlone) {
  std::vector<PathSample> samples;
  RandomDraws draws(3);
  for (int i = 0; i < 150; ++i) {
    PathSample sample;
    sample.coordinates.resize(2);
    for (double& q : sample.coordinates) q = draws.Uniform(-1, 1);
    // Legendre polynomials of degree 2 and 3, as the samples span the range.
    const double x = sample.coordinates[0], y = sample.coordinates[1];
    const double p = (3 * x * x - 1) / 2, dp = 3 * x;
    const double r = (5 * y * y * y - 3 * y) / 2, dr = (15 * y * y - 3) / 2;
    sample.length = 200 + 10 * p * r;
    sample.arms = Eigen::Vector2d(-10 * dp * r, -10 * p * dr);
    samples.push_back(sample);
  }
  const PathFit fit = FitPath(samples, {0, 1});
  // The penalty on its degree takes some hundredths of it.
  EXPECT_LT(fit.held_back.length.largest, 1);
  EXPECT_GE(fit.path.exponents.rowwise().sum().maxCoeff(), 5);
}

// What noise adds is not taken for a term: with it, held-back errors stay near
// those of the noise itself, whose mean is half of its largest.
TEST(PathFit, DoesNotFollowNoise) {
  constexpr double kNoise = 0.5;
  const PathFit fit = FitPath(CubicSamples(200, kNoise), {0, 1});
  EXPECT_LT(fit.path.coefficients.size(), 25);
  EXPECT_LT(fit.held_back.length.mean, 0.6 * kNoise);
  EXPECT_LT(fit.held_back.arm.mean, 0.6 * kNoise);
  EXPECT_GT(fit.held_back.arm.mean, 0.4 * kNoise);
}

TEST(PathFit, HeldBackErrorsAreThoseOfSamplesThatItDoesNotKnow) {
  // One of the samples is wrong by 20 mm. The function that knows it comes
  // nearer to it than those that do not.
  std::vector<PathSample> samples = CubicSamples(30);
  samples[17].length += 20;
  const PathFit fit = FitPath(samples, {0, 1});
  EXPECT_EQ(fit.held_back.length.worst_sample, 17);
  EXPECT_GT(fit.held_back.length.largest, fit.at_samples.length.largest);
}

TEST(PathFit, OrderedErrorsAreOrdered) {
  const PathFit fit = FitPath(CubicSamples(100, 0.3), {0, 1});
  for (const ErrorFigures& figures :
       {fit.held_back.length, fit.held_back.arm, fit.at_samples.arm}) {
    EXPECT_LT(figures.mean, figures.rms);
    EXPECT_LT(figures.rms, figures.quantile_95);
    EXPECT_LE(figures.quantile_95, figures.largest);
  }
}

// Only x moves: y enters by its arms, and so linearly.
TEST(PathFit, CoordinateThatDoesNotVaryEntersLinearly) {
  std::vector<PathSample> samples;
  for (int i = 0; i < 18; ++i) samples.push_back(CubicAt(-0.5 + 0.1 * i, 0.2));
  const PathFit fit = FitPath(samples, {0, 1});
  EXPECT_EQ(fit.path.exponents.col(1).maxCoeff(), 1);
  const PathValue value = Evaluate(fit.path, Eigen::Vector2d(0.37, 0.2));
  EXPECT_NEAR(value.arms[1], CubicAt(0.37, 0.2).arms[1], 1e-3);
}

TEST(PathFit, TakesTheCoordinatesThatItIsGiven) {
  const PathFit fit = FitPath(CubicSamples(40), {1});
  EXPECT_THAT(fit.path.coordinates, ElementsAre(1));
  EXPECT_EQ(fit.path.exponents.cols(), 1);
  EXPECT_EQ(fit.path.low.size(), 1);
}

TEST(PathFit, OfOneSampleIsItsTangent) {
  const PathFit fit = FitPath({CubicAt(0.2, 0.1)}, {0, 1});
  EXPECT_EQ(fit.held_back.length.worst_sample, -1);
  const PathValue value = Evaluate(fit.path, Eigen::Vector2d(0.2, 0.1));
  EXPECT_NEAR(value.length, CubicAt(0.2, 0.1).length, kPenalised);
  EXPECT_LT((value.arms - CubicAt(0.2, 0.1).arms).norm(), 5 * kPenalised);
}

TEST(PathFit, IsEquallyGoodInDegreesOfScale) {
  // A coordinate in other units is the same path: its terms are scaled.
  std::vector<PathSample> samples = CubicSamples(60, 0.2);
  const PathFit fit = FitPath(samples, {0, 1});
  for (PathSample& sample : samples) sample.coordinates[0] += 5;
  const PathFit shifted = FitPath(samples, {0, 1});
  EXPECT_NEAR(shifted.held_back.arm.mean, fit.held_back.arm.mean, 1e-5);
}

}  // namespace
}  // namespace musclewarp
