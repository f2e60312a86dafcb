// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ceres/dynamic_autodiff_cost_function.h>

#include <utility>
#include <vector>

namespace musclewarp {

// Preserves the shape of the coarse mesh around its vertex i: the Laplacian
// coordinate of the vertex should equal delta_i, that of the rest pose rotated
// along with the skeleton (paper eq. 2.1 to 2.3):
//
//   r = sum_j w_ij (x_j - x_i) - delta_i,      3 residuals, mm.
//
// Parameter blocks: x_i, then its neighbours x_j in the order of the weights,
// each of size 3, mm.
struct LaplacianTerm {
  LaplacianTerm(std::vector<double> neighbour_weights,
                const double* pre_rotated_delta)
      : weights(std::move(neighbour_weights)),
        delta{
            pre_rotated_delta[0], pre_rotated_delta[1], pre_rotated_delta[2]} {}

  template <typename T>
  bool operator()(T const* const* x, T* residual) const {
    for (int k = 0; k < 3; ++k) {
      residual[k] = T(-delta[k]);
      for (size_t j = 0; j < weights.size(); ++j) {
        residual[k] += weights[j] * (x[j + 1][k] - x[0][k]);
      }
    }
    return true;
  }

  // Makes the cost function, differentiated automatically, for the weights w_ij
  // of the neighbours and a delta_i of three numbers. The caller owns it, as a
  // rule by giving it to a ceres::Problem.
  static ceres::CostFunction* Create(std::vector<double> weights,
                                     const double* delta) {
    const size_t blocks = weights.size() + 1;
    auto* cost = new ceres::DynamicAutoDiffCostFunction<LaplacianTerm>(
        new LaplacianTerm(std::move(weights), delta));
    for (size_t i = 0; i < blocks; ++i) cost->AddParameterBlock(3);
    cost->SetNumResiduals(3);
    return cost;
  }

  const std::vector<double> weights;
  const double delta[3];
};

}  // namespace musclewarp
