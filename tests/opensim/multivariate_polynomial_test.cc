// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/multivariate_polynomial.h"

#include <gtest/gtest.h>

namespace musclewarp {
namespace {

MultivariatePolynomial SomePolynomial() {
  MultivariatePolynomial polynomial{3, 4, {}};
  const int count = static_cast<int>(Monomials(3, 4).rows());
  polynomial.coefficients.resize(count);
  for (int i = 0; i < count; ++i) {
    polynomial.coefficients[i] = (i * 7 % 11) / 5. - 1;
  }
  return polynomial;
}

// The order of the loops of OpenSim's MultivariatePolynomialFunction.
TEST(MultivariatePolynomial, HasTheMonomialsOfOpenSim) {
  Eigen::MatrixXi expected(6, 2);
  expected << 0, 0, 0, 1, 0, 2, 1, 0, 1, 1, 2, 0;
  EXPECT_EQ(Monomials(2, 2), expected);
  EXPECT_EQ(Monomials(6, 3).rows(), 84);  // 9 choose 3
}

TEST(MultivariatePolynomial, ValueByHand) {
  MultivariatePolynomial polynomial{2, 2, Eigen::VectorXd(6)};
  polynomial.coefficients << 1, 2, 3, 4, 5, 6;
  const double x = 2, y = 3;
  EXPECT_DOUBLE_EQ(PolynomialValue(polynomial, Eigen::Vector2d(x, y)),
                   1 + 2 * y + 3 * y * y + 4 * x + 5 * x * y + 6 * x * x);
  EXPECT_DOUBLE_EQ(MakeMultivariatePolynomial(polynomial)->Value({x, y}),
                   PolynomialValue(polynomial, Eigen::Vector2d(x, y)));
}

TEST(MultivariatePolynomial, DerivativeIsThatOfDifferences) {
  const MultivariatePolynomial polynomial = SomePolynomial();
  const Eigen::Vector3d at(0.4, -0.7, 1.1);
  constexpr double kStep = 1e-5;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(k);
    const double difference = (PolynomialValue(polynomial, at + step) -
                               PolynomialValue(polynomial, at - step)) /
                              (2 * kStep);
    // Third derivatives of about 100 times the square of the step.
    EXPECT_NEAR(PolynomialDerivative(polynomial, k, at), difference, 1e-8);
  }
}

TEST(MultivariatePolynomial, UnscaledIsTheSameFunction) {
  const MultivariatePolynomial polynomial = SomePolynomial();
  const Eigen::Vector3d centre(0.5, -0.2, 0), scale(0.7, 2, 0.3);
  const Eigen::Vector3d at(0.3, 0.8, -0.1);
  EXPECT_NEAR(PolynomialValue(Unscaled(polynomial, centre, scale), at),
              PolynomialValue(polynomial, (at - centre).cwiseQuotient(scale)),
              1e-12);
}

}  // namespace
}  // namespace musclewarp
