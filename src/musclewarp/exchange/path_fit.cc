// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/path_fit.h"

#include <glog/logging.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "musclewarp/base/input_error.h"

namespace musclewarp {
namespace {

constexpr double kSmallestArm = 1e-3;  // mm
constexpr int kMaxOrder = 9;
constexpr int kMaxMonomials = 500;

// The samples of the coordinates that matter, and how they are scaled.
struct Problem {
  std::vector<PathSample> samples;
  Eigen::VectorXd centre, scale;
};

std::vector<int> CoordinatesWithArms(const std::vector<PathSample>& samples) {
  std::vector<int> coordinates;
  for (int k = 0; k < samples[0].arms.size(); ++k) {
    const bool matters =
        std::any_of(samples.begin(), samples.end(), [&](const PathSample& s) {
          return std::abs(s.arms[k]) >= kSmallestArm;
        });
    if (matters) coordinates.push_back(k);
  }
  return coordinates;
}

Problem ProblemOf(const std::vector<PathSample>& samples,
                  const std::vector<int>& coordinates) {
  const int dimension = static_cast<int>(coordinates.size());
  Problem problem;
  problem.centre.resize(dimension);
  problem.scale.resize(dimension);
  problem.samples.resize(samples.size());
  for (PathSample& sample : problem.samples) {
    sample.coordinates.resize(dimension);
    sample.arms.resize(dimension);
  }
  for (int k = 0; k < dimension; ++k) {
    std::vector<double> values;
    for (size_t i = 0; i < samples.size(); ++i) {
      PathSample& sample = problem.samples[i];
      sample.length = samples[i].length;
      sample.coordinates[k] = samples[i].coordinates[coordinates[k]];
      sample.arms[k] = samples[i].arms[coordinates[k]];
      values.push_back(sample.coordinates[k]);
    }
    std::sort(values.begin(), values.end());
    const double centre = values[values.size() / 2];
    const double range =
        std::max(values.back() - centre, centre - values.front());
    problem.centre[k] = centre;
    problem.scale[k] = range > 1e-9 ? range : 1;
  }
  return problem;
}

MultivariatePolynomial Solve(const Problem& problem,
                             int order,
                             const PathFitOptions& options) {
  const int dimension = static_cast<int>(problem.centre.size());
  const Eigen::MatrixXi monomials = Monomials(dimension, order);
  Eigen::MatrixXd rows(problem.samples.size() * (1 + dimension),
                       monomials.rows());
  Eigen::VectorXd right(rows.rows());
  int row = 0;
  for (const PathSample& sample : problem.samples) {
    const Eigen::VectorXd at =
        (sample.coordinates - problem.centre).cwiseQuotient(problem.scale);
    rows.row(row) = MonomialValues(monomials, at) / options.max_length_error;
    right[row++] = sample.length / options.max_length_error;
    for (int k = 0; k < dimension; ++k) {
      rows.row(row) = MonomialValues(monomials, at, k) /
                      (-problem.scale[k] * options.max_arm_error);
      right[row++] = sample.arms[k] / options.max_arm_error;
    }
  }
  // Directions below this share of the largest are not determined by samples.
  constexpr double kUndetermined = 1e-9;
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
  solver.setThreshold(kUndetermined);
  solver.compute(rows);
  const MultivariatePolynomial scaled = {dimension, order, solver.solve(right)};
  return Unscaled(scaled, problem.centre, problem.scale);
}

PathErrors ErrorsOf(const MultivariatePolynomial& length,
                    const std::vector<PathSample>& samples) {
  PathErrors errors;
  const Eigen::MatrixXi monomials = Monomials(length.dimension, length.order);
  for (const PathSample& sample : samples) {
    const auto value = [&](int coordinate) {
      return length.coefficients.dot(
          MonomialValues(monomials, sample.coordinates, coordinate));
    };
    const double error = std::abs(value(-1) - sample.length);
    errors.length_max = std::max(errors.length_max, error);
    errors.length_rms += error * error;
    for (int k = 0; k < length.dimension; ++k) {
      const double arm_error = std::abs(-value(k) - sample.arms[k]);
      errors.arm_max = std::max(errors.arm_max, arm_error);
      errors.arm_rms += arm_error * arm_error;
    }
  }
  const double count = static_cast<double>(samples.size());
  errors.length_rms = std::sqrt(errors.length_rms / count);
  errors.arm_rms = std::sqrt(errors.arm_rms / (count * length.dimension));
  return errors;
}

// The largest errors as shares of the bounds; 1 is at the bound.
double Share(const PathErrors& errors, const PathFitOptions& options) {
  return std::max(errors.length_max / options.max_length_error,
                  errors.arm_max / options.max_arm_error);
}

}  // namespace

PathFit FitPath(const std::string& name,
                const std::vector<PathSample>& samples,
                const PathFitOptions& options) {
  CHECK(!samples.empty());
  PathFit best;
  const std::vector<int> coordinates = CoordinatesWithArms(samples);
  const int dimension = static_cast<int>(coordinates.size());
  if (dimension < 1 || dimension > kMaxPolynomialDimension) {
    throw InputError(
        "line \"" + name + "\"",
        "has moment arms about " + std::to_string(dimension) + " coordinates",
        "OpenSim's path functions take 1 to " +
            std::to_string(kMaxPolynomialDimension));
  }
  const Problem problem = ProblemOf(samples, coordinates);
  double best_fraction = 0;
  for (int order = 1; order <= kMaxOrder; ++order) {
    if (order > 1 && Monomials(dimension, order).rows() > kMaxMonomials) break;
    PathFit fit;
    fit.coordinates = coordinates;
    fit.length = Solve(problem, order, options);
    fit.errors = ErrorsOf(fit.length, problem.samples);
    const double share = Share(fit.errors, options);
    if (order == 1 || share < best_fraction) {
      best = fit;
      best_fraction = share;
    }
    if (share <= 1) break;
  }
  best.within_bounds = best_fraction <= 1;
  return best;
}

}  // namespace musclewarp
