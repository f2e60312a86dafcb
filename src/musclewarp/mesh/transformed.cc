// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh/transformed.h"

#include <Eigen/Geometry>

namespace musclewarp {

Points Transformed(const Points& points, const Eigen::Matrix4d& b_from_a) {
  Points moved = points * b_from_a.topLeftCorner<3, 3>().transpose();
  moved.rowwise() += b_from_a.topRightCorner<3, 1>().transpose();
  return moved;
}

Eigen::Matrix4d RigidInverse(const Eigen::Matrix4d& b_from_a) {
  return Eigen::Isometry3d(b_from_a).inverse().matrix();
}

}  // namespace musclewarp
