// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>

namespace musclewarp {

// Returns why a matrix is no rigid motion, such as "has a last row that is not
// 0 0 0 1", or an empty text if it is one. Its upper left 3 x 3 may differ from
// a rotation as far as one that was written with four digits does: by 1e-3 in
// R^T R. Numbers that are not finite are a fault.
std::string RigidMotionFault(const Eigen::Matrix4d& transform);

}  // namespace musclewarp
