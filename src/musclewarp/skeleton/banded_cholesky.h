// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace musclewarp {

// The lower triangle of a symmetric band matrix A: entry (k, j) is A(j + k, j).
// Entries beyond the last row of A are not used.
using SymmetricBand = Eigen::MatrixXd;

// Factors A = L L^T in place. Returns false if A is not positive definite.
bool FactorBand(SymmetricBand* a);

// Solves A x = b with the factor L of A, in place.
void SolveBand(const SymmetricBand& factor, Eigen::VectorXd* b);

}  // namespace musclewarp
