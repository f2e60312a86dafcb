// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/path_functions/path_function.h"

#include <glog/logging.h>

#include <algorithm>
#include <array>

namespace musclewarp {
namespace {

// The factors of all terms: powers of the coordinates, which go on linearly
// beyond the range, and their derivatives.
class Factors {
 public:
  Factors(const PathFunction& path, const Eigen::VectorXd& at) {
    for (Eigen::Index k = 0; k < at.size(); ++k) {
      const double nearest = std::clamp(at[k], path.low[k], path.high[k]);
      const double beyond = at[k] - nearest;
      is_inside_ = is_inside_ && beyond == 0;
      double power = 1, slope = 0;
      for (int n = 0; n <= kMostDegree; ++n) {
        values_[k][n] = power + slope * beyond;
        slopes_[k][n] = slope;
        slope = (n + 1) * power;
        power *= nearest;
      }
    }
  }

  double Value(Eigen::Index k, int n) const { return values_[k][n]; }
  double Slope(Eigen::Index k, int n) const { return slopes_[k][n]; }
  bool is_inside() const { return is_inside_; }

 private:
  using OfCoordinate = std::array<double, kMostDegree + 1>;
  std::array<OfCoordinate, kMostPathCoordinates> values_, slopes_;
  bool is_inside_ = true;
};

}  // namespace

void Evaluate(const PathFunction& path,
              const Eigen::VectorXd& at,
              PathValue* value) {
  const Eigen::Index dimension = path.exponents.cols();
  CHECK_EQ(at.size(), dimension);
  const Factors factors(path, at);
  value->is_inside_range = factors.is_inside();
  value->length = 0;
  value->arms.setZero(dimension);
  // The product of the factors before each one.
  std::array<double, kMostPathCoordinates + 1> before;
  for (Eigen::Index i = 0; i < path.exponents.rows(); ++i) {
    before[0] = path.coefficients[i];
    for (Eigen::Index k = 0; k < dimension; ++k) {
      before[k + 1] = before[k] * factors.Value(k, path.exponents(i, k));
    }
    value->length += before[dimension];
    double behind = 1;
    for (Eigen::Index k = dimension - 1; k >= 0; --k) {
      const int n = path.exponents(i, k);
      value->arms[k] -= before[k] * factors.Slope(k, n) * behind;
      behind *= factors.Value(k, n);
    }
  }
}

PathValue Evaluate(const PathFunction& path, const Eigen::VectorXd& at) {
  PathValue value;
  Evaluate(path, at, &value);
  return value;
}

}  // namespace musclewarp
