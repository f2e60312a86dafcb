// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ceres/autodiff_cost_function.h>

namespace musclewarp {

// The linear energy in whitened unknowns (Whitening), where all Laplacian,
// skeleton and attachment rows together become one block per unknown:
//
//   r = y_i,      3 residuals, mm.
//
// The sum over all unknowns is 1/2 |Y|^2, the linear energy but for a constant
// (paper eq. 2.8).
//
// Parameter block: y_i, of size 3, mm.
struct WhitenedLinearTerm {
  template <typename T>
  bool operator()(const T* y, T* residual) const {
    for (int k = 0; k < 3; ++k) residual[k] = y[k];
    return true;
  }

  // Makes the cost function; the caller owns it.
  static ceres::CostFunction* Create() {
    return new ceres::AutoDiffCostFunction<WhitenedLinearTerm, 3, 3>(
        new WhitenedLinearTerm);
  }
};

}  // namespace musclewarp
