// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/multivariate_polynomial.h"

#include <glog/logging.h>

#include <cmath>
#include <map>
#include <utility>

namespace musclewarp {
namespace {

void AddMonomials(int coordinate,
                  int left,
                  std::vector<int>* exponents,
                  std::vector<std::vector<int>>* monomials) {
  if (coordinate == static_cast<int>(exponents->size())) {
    monomials->push_back(*exponents);
    return;
  }
  for (int exponent = 0; exponent <= left; ++exponent) {
    (*exponents)[coordinate] = exponent;
    AddMonomials(coordinate + 1, left - exponent, exponents, monomials);
  }
}

class PolynomialOfCoordinates : public Function {
 public:
  explicit PolynomialOfCoordinates(MultivariatePolynomial polynomial)
      : polynomial_(std::move(polynomial)) {}

  double Value(const std::vector<double>& arguments) const override {
    return PolynomialValue(polynomial_,
                           Eigen::Map<const Eigen::VectorXd>(
                               arguments.data(), polynomial_.dimension));
  }

  size_t Arity() const override { return polynomial_.dimension; }

 private:
  MultivariatePolynomial polynomial_;
};

// Coefficients by exponents.
using Terms = std::map<std::vector<int>, double>;

// Returns the terms times (x - centre) / scale of a coordinate.
Terms TimesLinear(const Terms& terms,
                  int coordinate,
                  double centre,
                  double scale) {
  Terms product;
  for (const auto& term : terms) {
    std::vector<int> exponents = term.first;
    product[exponents] -= term.second * centre / scale;
    ++exponents[coordinate];
    product[exponents] += term.second / scale;
  }
  return product;
}

}  // namespace

Eigen::MatrixXi Monomials(int dimension, int order) {
  CHECK(dimension >= 1 && dimension <= kMaxPolynomialDimension) << dimension;
  CHECK_GE(order, 0);
  std::vector<int> exponents(dimension, 0);
  std::vector<std::vector<int>> list;
  AddMonomials(0, order, &exponents, &list);
  Eigen::MatrixXi monomials(list.size(), dimension);
  for (size_t i = 0; i < list.size(); ++i) {
    for (int k = 0; k < dimension; ++k) monomials(i, k) = list[i][k];
  }
  return monomials;
}

Eigen::VectorXd MonomialValues(const Eigen::MatrixXi& monomials,
                               const Eigen::VectorXd& at,
                               int coordinate) {
  CHECK_EQ(monomials.cols(), at.size());
  Eigen::VectorXd values(monomials.rows());
  for (int i = 0; i < monomials.rows(); ++i) {
    double value = 1;
    for (int k = 0; k < monomials.cols(); ++k) {
      const int exponent = monomials(i, k);
      if (k != coordinate) {
        value *= std::pow(at[k], exponent);
      } else {
        value *= exponent == 0 ? 0 : exponent * std::pow(at[k], exponent - 1);
      }
    }
    values[i] = value;
  }
  return values;
}

double PolynomialValue(const MultivariatePolynomial& polynomial,
                       const Eigen::VectorXd& at) {
  return polynomial.coefficients.dot(
      MonomialValues(Monomials(polynomial.dimension, polynomial.order), at));
}

double PolynomialDerivative(const MultivariatePolynomial& polynomial,
                            int coordinate,
                            const Eigen::VectorXd& at) {
  return polynomial.coefficients.dot(MonomialValues(
      Monomials(polynomial.dimension, polynomial.order), at, coordinate));
}

MultivariatePolynomial Unscaled(const MultivariatePolynomial& p,
                                const Eigen::VectorXd& centre,
                                const Eigen::VectorXd& scale) {
  CHECK_EQ(centre.size(), p.dimension);
  CHECK_EQ(scale.size(), p.dimension);
  const Eigen::MatrixXi monomials = Monomials(p.dimension, p.order);
  Terms sum;
  for (int i = 0; i < monomials.rows(); ++i) {
    if (p.coefficients[i] == 0) continue;
    Terms terms = {{std::vector<int>(p.dimension, 0), p.coefficients[i]}};
    for (int k = 0; k < p.dimension; ++k) {
      for (int n = 0; n < monomials(i, k); ++n) {
        terms = TimesLinear(terms, k, centre[k], scale[k]);
      }
    }
    for (const auto& term : terms) sum[term.first] += term.second;
  }
  MultivariatePolynomial q = p;
  for (int i = 0; i < monomials.rows(); ++i) {
    std::vector<int> exponents(p.dimension);
    for (int k = 0; k < p.dimension; ++k) exponents[k] = monomials(i, k);
    const auto term = sum.find(exponents);
    q.coefficients[i] = term == sum.end() ? 0 : term->second;
  }
  return q;
}

FunctionPtr MakeMultivariatePolynomial(MultivariatePolynomial polynomial) {
  return std::make_shared<PolynomialOfCoordinates>(std::move(polynomial));
}

}  // namespace musclewarp
