// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace musclewarp {

// Products of a few rows of a matrix in single precision, one after the other
// in memory, with three columns in double precision. `Rows` is 1 or 4. On
// processors that have them they use registers of four numbers and fused
// multiplication, so that results differ between processors by rounding.

// results[3 r + k] = row r . column k, for rows and columns of `size` numbers.
template <int Rows>
void Dots(const float* rows,
          const double* columns,
          Eigen::Index size,
          double* results);

// column k += factors[3 r + k] * row r.
template <int Rows>
void AddRows(const float* rows,
             const double* factors,
             Eigen::Index size,
             double* columns);

}  // namespace musclewarp
