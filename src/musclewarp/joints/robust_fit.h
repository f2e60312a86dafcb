// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ceres/tiny_solver.h>
#include <ceres/tiny_solver_autodiff_function.h>

#include <Eigen/Core>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Returns a number with the sign of a distance whose square is rho(distance),
// where rho is that of Ceres' SoftLOneLoss: quadratic below about `scale`,
// linear far beyond. It is differentiable everywhere, so that least squares of
// it are a robust fit.
template <typename T>
T RobustResidual(const T& distance, double scale) {
  using std::sqrt;
  // rho(s) = 2 (sqrt(1 + s) - 1) = 2 s / (sqrt(1 + s) + 1), s = (d / scale)^2.
  const T squared = distance * distance / (scale * scale);
  return distance * sqrt(T(2) / (sqrt(T(1) + squared) + T(1)));
}

// The residuals of a model at points, in the form of ceres::TinySolver. A model
// has the number of its parameters as kParameters and
//
//   template <typename T>
//   T operator()(const T* parameters, const double* point) const;
template <typename Model>
struct PointResiduals {
  const Model& model;
  const Points& points;            // #P x 3
  const Eigen::VectorXd& weights;  // #P, by which residuals are multiplied

  int NumResiduals() const { return static_cast<int>(points.rows()); }
  template <typename T>
  bool operator()(const T* parameters, T* residuals) const {
    for (int i = 0; i < points.rows(); ++i) {
      residuals[i] = weights[i] * model(parameters, points.data() + 3 * i);
    }
    return true;
  }
};

// Returns the parameters that minimise the sum of the squares of the residuals
// of a model, starting at `start`.
template <typename Model>
Eigen::Matrix<double, Model::kParameters, 1> FitToPoints(
    const Model& model,
    const Points& points,
    const Eigen::VectorXd& weights,
    Eigen::Matrix<double, Model::kParameters, 1> start) {
  using SummedResiduals =
      ceres::TinySolverAutoDiffFunction<PointResiduals<Model>,
                                        Eigen::Dynamic,
                                        Model::kParameters>;
  const PointResiduals<Model> residuals = {model, points, weights};
  SummedResiduals function(residuals);
  ceres::TinySolver<SummedResiduals> solver;
  solver.options.max_num_iterations = 30;
  solver.Solve(function, &start);
  return start;
}

}  // namespace musclewarp
