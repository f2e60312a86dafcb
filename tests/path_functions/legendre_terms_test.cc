// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/path_functions/legendre_terms.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace musclewarp {
namespace {

using ::testing::UnorderedElementsAre;

// Legendre polynomials of degree 12 have coefficients of 1e5 in x and, as the
// range begins at twice its width from 0, of 1e10 in q.
constexpr double kTermRounding = 1e-5;

TEST(LegendreTerms, AreAllUpToADegreeWithinTheLimit) {
  for (int dimension = 1; dimension <= 8; ++dimension) {
    const LegendreTerms terms =
        AllTerms(Eigen::VectorXd::Constant(dimension, -1),
                 Eigen::VectorXd::Constant(dimension, 2));
    EXPECT_LE(terms.degrees.rows(), kMostTerms);
    EXPECT_TRUE(terms.degrees.row(0).isZero());
    std::set<std::vector<int>> different;
    for (Eigen::Index i = 0; i < terms.degrees.rows(); ++i) {
      const Eigen::VectorXi row = terms.degrees.row(i);
      EXPECT_LE(row.sum(), kMostDegree);
      different.insert({row.data(), row.data() + row.size()});
    }
    EXPECT_EQ(different.size(), static_cast<size_t>(terms.degrees.rows()));
  }
}

TEST(LegendreTerms, HaveTheTermsBelow) {
  const LegendreTerms terms =
      AllTerms(Eigen::Vector2d(-1, -1), Eigen::Vector2d(1, 1));
  const auto below = TermsBelow(terms);
  for (Eigen::Index i = 0; i < terms.degrees.rows(); ++i) {
    if (terms.degrees(i, 0) != 2 || terms.degrees(i, 1) != 1) continue;
    std::vector<std::pair<int, int>> degrees;
    for (const int j : below[i]) {
      degrees.emplace_back(terms.degrees(j, 0), terms.degrees(j, 1));
    }
    EXPECT_THAT(degrees,
                UnorderedElementsAre(std::pair(1, 1), std::pair(2, 0)));
  }
  EXPECT_TRUE(below[0].empty());
}

// The sum of all terms is the same as a polynomial of the coordinates, in value
// and derivatives.
TEST(LegendreTerms, AreThePolynomialThatTheyAreWrittenAs) {
  const LegendreTerms terms =
      AllTerms(Eigen::Vector2d(-0.3, 0.5), Eigen::Vector2d(1.2, 0.9));
  std::vector<int> all(terms.degrees.rows());
  Eigen::VectorXd coefficients(terms.degrees.rows());
  for (size_t i = 0; i < all.size(); ++i) {
    all[i] = static_cast<int>(i);
    coefficients[all[i]] = 1.0 / (1 + all[i]);
  }
  PathFunction path;
  SetPolynomial(terms, all, coefficients, &path);
  path.low = Eigen::Vector2d(-1, -1);
  path.high = Eigen::Vector2d(2, 2);
  EXPECT_EQ(path.exponents.rows(), terms.degrees.rows());
  for (const double x : {-0.3, 0.1, 1.2}) {
    for (const double y : {0.5, 0.8}) {
      const Eigen::Vector2d at(x, y);
      const PathValue value = Evaluate(path, at);
      EXPECT_NEAR(
          value.length, TermValues(terms, at).dot(coefficients), kTermRounding);
      for (int k = 0; k < 2; ++k) {
        const double slope = TermValues(terms, at, k).dot(coefficients);
        EXPECT_NEAR(-value.arms[k], slope, kTermRounding * 10);
      }
    }
  }
}

}  // namespace
}  // namespace musclewarp
