// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

namespace musclewarp {

// The length of a path as one polynomial of coordinates, of which its moment
// arms are derivatives, so that both always agree:
//
//   l(q) = sum_i coefficients[i] * prod_k q[k]^exponents(i, k)
//
// Outside of the range it goes on linearly in each coordinate, since
// polynomials soon mean nothing there: the factor of a coordinate beyond its
// range is the tangent of the power at the end of the range. Length and arms
// are continuous everywhere.
struct PathFunction {
  // The coordinates on which the path depends, as ascending indices into a list
  // of names that is kept elsewhere.
  std::vector<int> coordinates;

  Eigen::MatrixXi exponents;     // #terms x #coordinates, at most kMostDegree
  Eigen::VectorXd coefficients;  // #terms, mm

  // The range of each coordinate in which there were samples, rad or m.
  Eigen::VectorXd low, high;
};

// The largest exponent of a coordinate, and the largest number of coordinates,
// of a PathFunction.
constexpr int kMostDegree = 12;
constexpr int kMostPathCoordinates = 24;

// The length of a path at some values of its coordinates.
struct PathValue {
  double length = 0;            // mm
  Eigen::VectorXd arms;         // -dl/dq of each coordinate, mm per rad or m
  bool is_inside_range = true;  // false where it is continued
};

// Evaluates a path function. `at`: the values of PathFunction::coordinates, rad
// or m.
PathValue Evaluate(const PathFunction& path, const Eigen::VectorXd& at);

// Does the same into a value whose memory is used again.
void Evaluate(const PathFunction& path,
              const Eigen::VectorXd& at,
              PathValue* value);

}  // namespace musclewarp
