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

Box3 Transformed(const Box3& box, const Eigen::Matrix4d& b_from_a) {
  Points corners(8, 3);
  for (int k = 0; k < 8; ++k) {
    corners.row(k) << (k & 1 ? box.upper : box.lower)[0],
        (k & 2 ? box.upper : box.lower)[1], (k & 4 ? box.upper : box.lower)[2];
  }
  return BoxOf(Transformed(corners, b_from_a));
}

Eigen::Matrix4d RigidInverse(const Eigen::Matrix4d& b_from_a) {
  return Eigen::Isometry3d(b_from_a).inverse().matrix();
}

}  // namespace musclewarp
