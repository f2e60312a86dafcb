// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/rigid_motion.h"

#include <Eigen/LU>

namespace musclewarp {

std::string RigidMotionFault(const Eigen::Matrix4d& transform) {
  // Some files write rotations with only 4 digits.
  constexpr double kTolerance = 1e-3;
  const Eigen::Matrix3d rotation = transform.topLeftCorner<3, 3>();
  if (!transform.allFinite() ||
      !(rotation.transpose() * rotation).isIdentity(kTolerance) ||
      rotation.determinant() < 0) {
    return "is not a rigid motion: its upper left 3 x 3 is not a rotation";
  }
  if (transform.row(3) != Eigen::RowVector4d(0, 0, 0, 1)) {
    return "has a last row that is not 0 0 0 1";
  }
  return "";
}

}  // namespace musclewarp
