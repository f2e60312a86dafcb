// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>

namespace musclewarp {

// Returns why a matrix is not a rigid motion, such as "has a last row that is
// not 0 0 0 1", or an empty text if it is one. The upper left 3 x 3 block R may
// deviate from a rotation by 1e-3 in R^T R, as rotations written with four
// digits do. Numbers that are not finite are a fault.
std::string RigidMotionFault(const Eigen::Matrix4d& transform);

}  // namespace musclewarp
