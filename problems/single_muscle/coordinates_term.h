// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ceres/dynamic_autodiff_cost_function.h>

#include <Eigen/Core>

namespace musclewarp {

// Draws a point of the muscle, given by mean value coordinates k_j of all
// coarse vertices x_j, to a target:
//
//   r = sum_j k_j x_j - target,      3 residuals, mm times the row's weight.
//
// The skeleton rows, paper eq. (2.4) and (2.5), the attachment rows and the
// bending rows, whose coordinates are second differences, are of this form.
// Coordinates and target include the weight of the row.
//
// Parameter blocks: the N coarse vertices in order, each of size 3, mm.
struct CoordinatesTerm {
  CoordinatesTerm(const Eigen::RowVectorXd& row, const double* row_target)
      : coordinates(row), target{row_target[0], row_target[1], row_target[2]} {}

  template <typename T>
  bool operator()(T const* const* x, T* residual) const {
    for (int k = 0; k < 3; ++k) {
      residual[k] = T(-target[k]);
      for (Eigen::Index j = 0; j < coordinates.size(); ++j) {
        residual[k] += coordinates[j] * x[j][k];
      }
    }
    return true;
  }

  // Makes the cost function, differentiated automatically, for coordinates
  // `row` (1 x N) and a target of three numbers. The caller owns it, as a rule
  // by giving it to a ceres::Problem.
  static ceres::CostFunction* Create(const Eigen::RowVectorXd& row,
                                     const double* target) {
    auto* cost = new ceres::DynamicAutoDiffCostFunction<CoordinatesTerm>(
        new CoordinatesTerm(row, target));
    for (Eigen::Index j = 0; j < row.size(); ++j) cost->AddParameterBlock(3);
    cost->SetNumResiduals(3);
    return cost;
  }

  const Eigen::RowVectorXd coordinates;
  const double target[3];
};

}  // namespace musclewarp
