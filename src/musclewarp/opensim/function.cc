// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/function.h"

#include <glog/logging.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace musclewarp {
namespace {

class Constant : public Function {
 public:
  explicit Constant(double value) : value_(value) {}
  double Value(const std::vector<double>&) const override { return value_; }
  size_t Arity() const override { return 0; }

 private:
  double value_;
};

class Linear : public Function {
 public:
  explicit Linear(std::vector<double> coefficients)
      : coefficients_(std::move(coefficients)) {}
  double Value(const std::vector<double>& arguments) const override {
    CHECK_GE(arguments.size(), Arity());
    double value = coefficients_.back();
    for (size_t i = 0; i + 1 < coefficients_.size(); ++i) {
      value += coefficients_[i] * arguments[i];
    }
    return value;
  }
  size_t Arity() const override { return coefficients_.size() - 1; }

 private:
  std::vector<double> coefficients_;
};

class Polynomial : public Function {
 public:
  explicit Polynomial(std::vector<double> coefficients)
      : coefficients_(std::move(coefficients)) {}
  double Value(const std::vector<double>& arguments) const override {
    double value = 0;
    for (const double coefficient : coefficients_) {
      value = value * arguments.at(0) + coefficient;
    }
    return value;
  }

 private:
  std::vector<double> coefficients_;
};

class Multiplier : public Function {
 public:
  Multiplier(double scale, FunctionPtr function)
      : scale_(scale), function_(std::move(function)) {}
  double Value(const std::vector<double>& arguments) const override {
    return scale_ * function_->Value(arguments);
  }
  size_t Arity() const override { return function_->Arity(); }

 private:
  double scale_;
  FunctionPtr function_;
};

void CheckKnots(const std::vector<double>& x, const std::vector<double>& y) {
  CHECK_EQ(x.size(), y.size());
  CHECK_GE(x.size(), 2u);
  for (size_t i = 0; i + 1 < x.size(); ++i) CHECK_LT(x[i], x[i + 1]);
}

// Index of the interval of `x` that holds `at`; the first or last outside.
size_t IntervalOf(const std::vector<double>& x, double at) {
  const auto above = std::upper_bound(x.begin() + 1, x.end() - 1, at);
  return above - x.begin() - 1;
}

class PiecewiseLinear : public Function {
 public:
  PiecewiseLinear(std::vector<double> x, std::vector<double> y)
      : x_(std::move(x)), y_(std::move(y)) {}
  double Value(const std::vector<double>& arguments) const override {
    const double at = arguments.at(0);
    const size_t i = IntervalOf(x_, at);
    const double slope = (y_[i + 1] - y_[i]) / (x_[i + 1] - x_[i]);
    return y_[i] + slope * (at - x_[i]);
  }

 private:
  std::vector<double> x_, y_;
};

// The third divided difference of the points i to i + 3, times 6: the third
// derivative of the cubic through them.
double ThirdDerivative(const std::vector<double>& x,
                       const std::vector<double>& y,
                       size_t i) {
  double d[4] = {y[i], y[i + 1], y[i + 2], y[i + 3]};
  for (size_t order = 1; order < 4; ++order) {
    for (size_t k = 0; k + order < 4; ++k) {
      d[k] = (d[k + 1] - d[k]) / (x[i + k + order] - x[i + k]);
    }
  }
  return 6 * d[0];
}

// Second derivatives at the knots: continuity of the slope at the inner ones,
// the third derivative of the end intervals at the outer ones.
Eigen::VectorXd SecondDerivatives(const std::vector<double>& x,
                                  const std::vector<double>& y) {
  const int n = static_cast<int>(x.size());
  if (n == 2) return Eigen::VectorXd::Zero(n);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  for (int i = 1; i + 1 < n; ++i) {
    const double before = x[i] - x[i - 1];
    const double after = x[i + 1] - x[i];
    matrix(i, i - 1) = before / 6;
    matrix(i, i) = (before + after) / 3;
    matrix(i, i + 1) = after / 6;
    right[i] = (y[i + 1] - y[i]) / after - (y[i] - y[i - 1]) / before;
  }
  matrix(0, 0) = matrix(n - 1, n - 2) = -1;
  matrix(0, 1) = matrix(n - 1, n - 1) = 1;
  if (n > 3) {
    right[0] = ThirdDerivative(x, y, 0) * (x[1] - x[0]);
    right[n - 1] = ThirdDerivative(x, y, n - 4) * (x[n - 1] - x[n - 2]);
  }
  return matrix.partialPivLu().solve(right);
}

class SimmSpline : public Function {
 public:
  SimmSpline(std::vector<double> x, std::vector<double> y)
      : x_(std::move(x)), y_(std::move(y)), bend_(SecondDerivatives(x_, y_)) {}

  double Value(const std::vector<double>& arguments) const override {
    const double at = arguments.at(0);
    const double inside = std::clamp(at, x_.front(), x_.back());
    const size_t i = IntervalOf(x_, inside);
    const double width = x_[i + 1] - x_[i];
    const double s = inside - x_[i];
    const double slope_0 =
        (y_[i + 1] - y_[i]) / width - width * (2 * bend_[i] + bend_[i + 1]) / 6;
    const double third = (bend_[i + 1] - bend_[i]) / width;
    const double value =
        y_[i] + s * (slope_0 + s * (bend_[i] / 2 + s * third / 6));
    const double slope = slope_0 + s * (bend_[i] + s * third / 2);
    return value + slope * (at - inside);
  }

 private:
  std::vector<double> x_, y_;
  Eigen::VectorXd bend_;  // second derivatives at the knots
};

}  // namespace

FunctionPtr MakeConstant(double value) {
  return std::make_shared<Constant>(value);
}

FunctionPtr MakeLinear(std::vector<double> coefficients) {
  CHECK(!coefficients.empty());
  return std::make_shared<Linear>(std::move(coefficients));
}

FunctionPtr MakePolynomial(std::vector<double> coefficients) {
  CHECK(!coefficients.empty());
  return std::make_shared<Polynomial>(std::move(coefficients));
}

FunctionPtr MakeSimmSpline(std::vector<double> x, std::vector<double> y) {
  CheckKnots(x, y);
  return std::make_shared<SimmSpline>(std::move(x), std::move(y));
}

FunctionPtr MakePiecewiseLinear(std::vector<double> x, std::vector<double> y) {
  CheckKnots(x, y);
  return std::make_shared<PiecewiseLinear>(std::move(x), std::move(y));
}

FunctionPtr MakeMultiplier(double scale, FunctionPtr function) {
  return std::make_shared<Multiplier>(scale, std::move(function));
}

}  // namespace musclewarp
