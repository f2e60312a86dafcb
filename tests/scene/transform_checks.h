// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace musclewarp {

// Rounding of places and lengths of some hundred mm, through a few transforms.
constexpr double kTransformRounding = 1e-11;

// The largest difference of two coefficients.
inline double Difference(const Eigen::Matrix4d& a, const Eigen::Matrix4d& b) {
  return (a - b).cwiseAbs().maxCoeff();
}

}  // namespace musclewarp
