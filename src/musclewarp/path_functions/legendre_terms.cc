// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/path_functions/legendre_terms.h"

#include <glog/logging.h>

#include <map>
#include <utility>

namespace musclewarp {
namespace {

using Degrees = std::vector<int>;

// Appends all degrees of the coordinates from one on that add up to `left`.
void AddDegrees(size_t coordinate,
                int left,
                Degrees* degrees,
                std::vector<Degrees>* list) {
  if (coordinate + 1 == degrees->size()) {
    (*degrees)[coordinate] = left;
    list->push_back(*degrees);
    return;
  }
  for (int degree = left; degree >= 0; --degree) {
    (*degrees)[coordinate] = degree;
    AddDegrees(coordinate + 1, left - degree, degrees, list);
  }
}

Degrees DegreesOf(const LegendreTerms& terms, Eigen::Index term) {
  Degrees degrees(terms.degrees.cols());
  for (size_t k = 0; k < degrees.size(); ++k) {
    degrees[k] = terms.degrees(term, k);
  }
  return degrees;
}

// Values or derivatives of the Legendre polynomials of degree 0 to kMostDegree.
Eigen::VectorXd LegendreValues(double x, bool derives) {
  Eigen::VectorXd values(kMostDegree + 1), slopes(kMostDegree + 1);
  values[0] = 1;
  values[1] = x;
  slopes[0] = 0;
  slopes[1] = 1;
  for (int n = 1; n < kMostDegree; ++n) {
    values[n + 1] = ((2 * n + 1) * x * values[n] - n * values[n - 1]) / (n + 1);
    slopes[n + 1] = slopes[n - 1] + (2 * n + 1) * values[n];
  }
  return derives ? slopes : values;
}

// Returns the coefficients of the Legendre polynomials of (q - centre) / scale
// as polynomials of q: row n has those of degree n, from the constant on.
Eigen::MatrixXd PowerCoefficients(double centre, double scale) {
  Eigen::MatrixXd rows =
      Eigen::MatrixXd::Zero(kMostDegree + 1, kMostDegree + 1);
  const auto times_x = [&](const Eigen::RowVectorXd& row) {
    Eigen::RowVectorXd product = -centre / scale * row;
    product.tail(kMostDegree) += row.head(kMostDegree) / scale;
    return product;
  };
  rows(0, 0) = 1;
  rows.row(1) = times_x(rows.row(0));
  for (int n = 1; n < kMostDegree; ++n) {
    rows.row(n + 1) =
        ((2 * n + 1) * times_x(rows.row(n)) - n * rows.row(n - 1)) / (n + 1);
  }
  return rows;
}

}  // namespace

LegendreTerms AllTerms(const Eigen::VectorXd& low,
                       const Eigen::VectorXd& high) {
  const Eigen::Index dimension = low.size();
  CHECK(dimension >= 1 && dimension <= kMostPathCoordinates) << dimension;
  LegendreTerms terms;
  terms.centre = (low + high) / 2;
  constexpr double kStandsStill = 1e-9;  // rad or m
  terms.scale = ((high - low).array() > kStandsStill)
                    .select((high - low) / 2, Eigen::VectorXd::Ones(dimension));
  std::vector<Degrees> list;
  Degrees degrees(dimension, 0);
  for (int order = 0; order <= kMostDegree; ++order) {
    std::vector<Degrees> more;
    AddDegrees(0, order, &degrees, &more);
    if (list.size() + more.size() > kMostTerms && order > 1) break;
    list.insert(list.end(), more.begin(), more.end());
  }
  terms.degrees.resize(static_cast<Eigen::Index>(list.size()), dimension);
  for (size_t i = 0; i < list.size(); ++i) {
    for (Eigen::Index k = 0; k < dimension; ++k) {
      terms.degrees(i, k) = list[i][k];
    }
  }
  return terms;
}

Eigen::RowVectorXd TermValues(const LegendreTerms& terms,
                              const Eigen::VectorXd& at,
                              int coordinate) {
  const Eigen::Index dimension = terms.degrees.cols();
  std::vector<Eigen::VectorXd> factors;
  for (Eigen::Index k = 0; k < dimension; ++k) {
    const double x = (at[k] - terms.centre[k]) / terms.scale[k];
    factors.push_back(LegendreValues(x, k == coordinate));
    if (k == coordinate) factors.back() /= terms.scale[k];
  }
  Eigen::RowVectorXd values = Eigen::RowVectorXd::Ones(terms.degrees.rows());
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    for (Eigen::Index k = 0; k < dimension; ++k) {
      values[i] *= factors[k][terms.degrees(i, k)];
    }
  }
  return values;
}

std::vector<std::vector<int>> TermsBelow(const LegendreTerms& terms) {
  std::map<Degrees, int> places;
  for (Eigen::Index i = 0; i < terms.degrees.rows(); ++i) {
    places[DegreesOf(terms, i)] = static_cast<int>(i);
  }
  std::vector<std::vector<int>> below(terms.degrees.rows());
  for (Eigen::Index i = 0; i < terms.degrees.rows(); ++i) {
    Degrees degrees = DegreesOf(terms, i);
    for (int& degree : degrees) {
      if (degree == 0) continue;
      --degree;
      below[i].push_back(places.at(degrees));
      ++degree;
    }
  }
  return below;
}

void SetPolynomial(const LegendreTerms& terms,
                   const std::vector<int>& chosen,
                   const Eigen::VectorXd& coefficients,
                   PathFunction* path) {
  const Eigen::Index dimension = terms.degrees.cols();
  std::vector<Eigen::MatrixXd> powers;
  for (Eigen::Index k = 0; k < dimension; ++k) {
    powers.push_back(PowerCoefficients(terms.centre[k], terms.scale[k]));
  }
  std::map<Degrees, double> sum;
  for (size_t i = 0; i < chosen.size(); ++i) {
    // The product of one polynomial of each coordinate.
    std::map<Degrees, double> product = {
        {Degrees(dimension, 0), coefficients[static_cast<int>(i)]}};
    for (Eigen::Index k = 0; k < dimension; ++k) {
      const int degree = terms.degrees(chosen[i], k);
      std::map<Degrees, double> longer;
      for (const auto& [exponents, coefficient] : product) {
        Degrees raised = exponents;
        for (int n = 0; n <= degree; ++n) {
          raised[k] = n;
          longer[raised] += coefficient * powers[k](degree, n);
        }
      }
      product = std::move(longer);
    }
    for (const auto& [exponents, coefficient] : product) {
      sum[exponents] += coefficient;
    }
  }
  path->exponents.resize(static_cast<Eigen::Index>(sum.size()), dimension);
  path->coefficients.resize(static_cast<Eigen::Index>(sum.size()));
  Eigen::Index row = 0;
  for (const auto& [exponents, coefficient] : sum) {
    for (Eigen::Index k = 0; k < dimension; ++k) {
      path->exponents(row, k) = exponents[k];
    }
    path->coefficients[row++] = coefficient;
  }
}

}  // namespace musclewarp
