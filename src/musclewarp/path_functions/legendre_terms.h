// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/path_functions/path_function.h"

namespace musclewarp {

// Products of Legendre polynomials of scaled coordinates, of which a path is
// fitted. Over evenly spread samples they are nearly orthogonal, which powers
// of coordinates are not.
struct LegendreTerms {
  Eigen::MatrixXi degrees;  // #terms x #coordinates

  // A coordinate q is scaled to (q - centre) / scale, from -1 to 1 in its
  // range.
  Eigen::VectorXd centre, scale;
};

// Returns all terms over ranges of coordinates up to the highest total degree,
// at most kMostDegree, with which there are at most kMostTerms of them; the
// constant comes first, and total degrees rise.
LegendreTerms AllTerms(const Eigen::VectorXd& low, const Eigen::VectorXd& high);

constexpr int kMostTerms = 400;

// Returns the values of all terms, 1 x #terms, or their derivatives by a
// coordinate.
Eigen::RowVectorXd TermValues(const LegendreTerms& terms,
                              const Eigen::VectorXd& at,
                              int coordinate = -1);

// Returns for each term those that have one degree less of one coordinate. A
// set that has these of all its terms spans the same functions for any centre
// and scale, and as many monomials as it has terms.
std::vector<std::vector<int>> TermsBelow(const LegendreTerms& terms);

// Writes the sum of some terms, with these coefficients, as a polynomial of the
// coordinates: sets PathFunction::exponents and coefficients. The set has to
// have the terms below each of its terms.
void SetPolynomial(const LegendreTerms& terms,
                   const std::vector<int>& chosen,
                   const Eigen::VectorXd& coefficients,
                   PathFunction* path);

}  // namespace musclewarp
