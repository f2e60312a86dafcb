// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <boost/rational.hpp>
#include <type_traits>
#include <utility>
#include <vector>

#include "musclewarp/proximity/triangle_bvh.h"

namespace musclewarp {

// Integers of the grid, and doubles as they are.
using GridNumber = boost::rational<long long>;
using RealNumber = boost::multiprecision::cpp_rational;

template <typename Number>
Number Exact(double value) {
  if constexpr (std::is_same_v<Number, GridNumber>) {
    return Number(static_cast<long long>(value));
  } else {
    return Number(value);
  }
}

template <typename Number>
using ExactPoint = std::array<Number, 3>;

// Solves sum_k x_k columns[k] = right for linearly independent columns; empty
// if they are not or there is no solution.
template <typename Number>
std::vector<Number> Solve(std::vector<std::array<Number, 5>> columns,
                          std::array<Number, 5> right) {
  const size_t count = columns.size();
  for (size_t k = 0; k < count; ++k) {
    size_t pivot = k;
    while (pivot < 5 && columns[k][pivot] == Number(0)) ++pivot;
    if (pivot == 5) return {};
    for (auto& column : columns) std::swap(column[k], column[pivot]);
    std::swap(right[k], right[pivot]);
    for (size_t row = 0; row < 5; ++row) {
      if (row == k || columns[k][row] == Number(0)) continue;
      const Number factor = columns[k][row] / columns[k][k];
      for (size_t j = k; j < count; ++j) {
        columns[j][row] -= factor * columns[j][k];
      }
      right[row] -= factor * right[k];
    }
  }
  for (size_t row = count; row < 5; ++row) {
    if (right[row] != Number(0)) return {};
  }
  std::vector<Number> x(count);
  for (size_t k = 0; k < count; ++k) x[k] = right[k] / columns[k][k];
  return x;
}

// The corners of the intersection of two triangles, by linear programming in
// exact arithmetic: the basic solutions of  sum s_i a_i = sum t_j b_j,
// sum s_i = 1 = sum t_j,  s, t >= 0.
template <typename Number>
std::vector<ExactPoint<Number>> IntersectionByBruteForce(const Corners& a,
                                                         const Corners& b) {
  std::vector<ExactPoint<Number>> found;
  for (int subset = 1; subset < 64; ++subset) {
    std::vector<std::array<Number, 5>> columns;
    std::vector<int> rows;
    for (int k = 0; k < 6; ++k) {
      if (!(subset >> k & 1)) continue;
      std::array<Number, 5> column;
      for (int axis = 0; axis < 3; ++axis) {
        column[axis] =
            k < 3 ? Exact<Number>(a(k, axis)) : -Exact<Number>(b(k - 3, axis));
      }
      column[3] = Number(k < 3 ? 1 : 0);
      column[4] = Number(k < 3 ? 0 : 1);
      columns.push_back(column);
      rows.push_back(k);
    }
    if (columns.size() > 5) continue;
    const auto x = Solve<Number>(
        columns, {Number(0), Number(0), Number(0), Number(1), Number(1)});
    if (x.empty() || std::any_of(x.begin(), x.end(), [](const Number& value) {
          return value < Number(0);
        })) {
      continue;
    }
    ExactPoint<Number> p = {Number(0), Number(0), Number(0)};
    for (size_t k = 0; k < x.size(); ++k) {
      if (rows[k] >= 3) continue;
      for (int axis = 0; axis < 3; ++axis) {
        p[axis] += x[k] * Exact<Number>(a(rows[k], axis));
      }
    }
    found.push_back(p);
  }
  return found;
}

}  // namespace musclewarp
