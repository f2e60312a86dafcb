// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace musclewarp {

// Products of a few rows of a matrix in single or double precision, one after
// the other in memory, with three columns in double precision. `Rows` is 1 or
// 4, `Number` is float or double. On processors that have them they use
// registers of four numbers and fused multiplication, so that results differ
// between processors by rounding.

// results[3 r + k] = row r . column k, for rows and columns of `size` numbers.
template <int Rows, typename Number>
void Dots(const Number* rows,
          const double* columns,
          Eigen::Index size,
          double* results);

// column k += factors[3 r + k] * row r.
template <int Rows, typename Number>
void AddRows(const Number* rows,
             const double* factors,
             Eigen::Index size,
             double* columns);

// Rows are taken four at a time, so that columns are loaded once for all of
// them: calls four(i) for every four of `count` rows and one(i) for those that
// are left.
template <typename Four, typename One>
void ForRows(Eigen::Index count, const Four& four, const One& one) {
  constexpr int kRows = 4;
  Eigen::Index i = 0;
  for (; i + kRows <= count; i += kRows) four(i);
  for (; i < count; ++i) one(i);
}

}  // namespace musclewarp
