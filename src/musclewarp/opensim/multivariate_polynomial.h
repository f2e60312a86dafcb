// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/opensim/function.h"

namespace musclewarp {

// The most coordinates of a polynomial. OpenSim 4.5 takes at most 6; later
// versions have no limit (opensim-core pull request 4001).
constexpr int kMaxPolynomialDimension = 24;

// A polynomial of several coordinates with all monomials up to a total order,
// as OpenSim's MultivariatePolynomialFunction has it. Its coefficients are in
// the order of Monomials.
struct MultivariatePolynomial {
  int dimension = 0;
  int order = 0;
  Eigen::VectorXd coefficients;
};

// Returns the exponents of all monomials, #monomials x dimension, in the order
// of OpenSim: the exponent of the last coordinate rises fastest. For dimension
// and order 2 these are 1, y, y^2, x, xy, x^2. Precondition (CHECKed):
// dimension is 1 to kMaxPolynomialDimension, order is not negative.
Eigen::MatrixXi Monomials(int dimension, int order);

// Returns the value of a polynomial, and its derivative by a coordinate.
// Precondition (CHECKed): `at` has its dimension.
double PolynomialValue(const MultivariatePolynomial& polynomial,
                       const Eigen::VectorXd& at);
double PolynomialDerivative(const MultivariatePolynomial& polynomial,
                            int coordinate,
                            const Eigen::VectorXd& at);

// Returns the value of each monomial (coordinate -1), or its derivative by a
// coordinate.
Eigen::VectorXd MonomialValues(const Eigen::MatrixXi& monomials,
                               const Eigen::VectorXd& at,
                               int coordinate = -1);

// Returns the polynomial q of the same order with q(x) = p((x - centre) /
// scale). Precondition (CHECKed): the vectors have the dimension of p.
MultivariatePolynomial Unscaled(const MultivariatePolynomial& p,
                                const Eigen::VectorXd& centre,
                                const Eigen::VectorXd& scale);

// Returns it as a function of `dimension` arguments.
FunctionPtr MakeMultivariatePolynomial(MultivariatePolynomial polynomial);

}  // namespace musclewarp
