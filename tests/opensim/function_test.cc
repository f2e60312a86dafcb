// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/function.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace musclewarp {
namespace {

// Rounding of values about 10.
constexpr double kValueRounding = 1e-13;

double Cubic(double x) { return 2 - 3 * x + 0.5 * x * x - 0.25 * x * x * x; }

TEST(Function, ConstantLinearPolynomialAndMultiplier) {
  EXPECT_EQ(MakeConstant(7)->Value({}), 7);
  EXPECT_EQ(MakeLinear({2, -1, 5})->Value({3, 4}), 2 * 3 - 4 + 5);
  EXPECT_EQ(MakeLinear({2, -1, 5})->Arity(), 2u);
  // Coefficients from the highest power down.
  EXPECT_EQ(MakePolynomial({2, 3, 4})->Value({10}), 234);
  EXPECT_EQ(MakeMultiplier(0.5, MakePolynomial({2, 3, 4}))->Value({10}), 117);
  EXPECT_EQ(MakeMultiplier(0.5, MakeConstant(1))->Arity(), 0u);
}

TEST(Function, PiecewiseLinearGoesOnStraight) {
  const auto function = MakePiecewiseLinear({0, 1, 3}, {0, 2, 0});
  EXPECT_EQ(function->Value({0.5}), 1);
  EXPECT_EQ(function->Value({1}), 2);
  EXPECT_EQ(function->Value({2}), 1);
  EXPECT_EQ(function->Value({-1}), -2);
  EXPECT_EQ(function->Value({5}), -2);
}

// The end conditions take the third derivative from four points: a cubic comes
// back as it is. A natural spline would bend it.
TEST(SimmSpline, ReproducesCubics) {
  const std::vector<double> x = {-2, -1.5, 0, 0.25, 1, 3};
  std::vector<double> y;
  for (const double value : x) y.push_back(Cubic(value));
  const auto spline = MakeSimmSpline(x, y);
  for (double at = -2; at <= 3; at += 0.125) {
    EXPECT_NEAR(spline->Value({at}), Cubic(at), kValueRounding) << at;
  }
}

TEST(SimmSpline, ThreePointsAreAParabolaAndTwoALine) {
  const auto parabola = MakeSimmSpline({0, 1, 3}, {0, 1, 9});
  EXPECT_NEAR(parabola->Value({2}), 4, kValueRounding);
  const auto line = MakeSimmSpline({0, 2}, {1, 5});
  EXPECT_NEAR(line->Value({0.5}), 2, kValueRounding);
  EXPECT_NEAR(line->Value({4}), 9, kValueRounding);
}

TEST(SimmSpline, PassesItsPointsWithContinuousSlopeAndGoesOnStraight) {
  const std::vector<double> x = {0, 1, 1.5, 4, 5};
  const std::vector<double> y = {0, 2, -1, 0, 3};
  const auto spline = MakeSimmSpline(x, y);
  // Of one-sided differences over this step: its half times the bend, which is
  // below 100 here.
  constexpr double kStep = 1e-6;
  constexpr double kSlope = 1e-4;
  for (size_t i = 0; i < x.size(); ++i) {
    EXPECT_NEAR(spline->Value({x[i]}), y[i], kValueRounding);
    const double before =
        (spline->Value({x[i]}) - spline->Value({x[i] - kStep})) / kStep;
    const double after =
        (spline->Value({x[i] + kStep}) - spline->Value({x[i]})) / kStep;
    EXPECT_NEAR(before, after, kSlope) << i;
  }
  const double end = spline->Value({5});
  EXPECT_NEAR(
      spline->Value({7}) - end, 2 * (spline->Value({6}) - end), kValueRounding);
}

}  // namespace
}  // namespace musclewarp
