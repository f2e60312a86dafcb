// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ceres/autodiff_cost_function.h>

namespace musclewarp {

// All linear rows of one whitened unknown (Whitening): r = y_i, 3 residuals.
struct WhitenedLinearTerm {
  template <typename T>
  bool operator()(const T* y, T* residual) const {
    for (int k = 0; k < 3; ++k) residual[k] = y[k];
    return true;
  }

  static ceres::CostFunction* Create() {
    return new ceres::AutoDiffCostFunction<WhitenedLinearTerm, 3, 3>(
        new WhitenedLinearTerm);
  }
};

}  // namespace musclewarp
