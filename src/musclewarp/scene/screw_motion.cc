// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/screw_motion.h"

#include <Eigen/Geometry>
#include <cmath>

namespace musclewarp {

ScrewMotion::ScrewMotion(const Eigen::Matrix4d& motion) {
  // Below this angle, rad, the position of the axis cannot be determined.
  constexpr double kNoTurn = 1e-9;
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(motion.topLeftCorner<3, 3>()));
  const Eigen::Vector3d move = motion.topRightCorner<3, 1>();
  axis_ = turn.axis();
  angle_ = turn.angle();
  if (angle_ < kNoTurn) {
    angle_ = 0;
    slide_ = move;
    centre_.setZero();
    return;
  }
  slide_ = axis_.dot(move) * axis_;
  const Eigen::Vector3d across = move - slide_;
  centre_ = (across + axis_.cross(across) / std::tan(angle_ / 2)) / 2;
}

Eigen::Matrix4d ScrewMotion::Part(double share) const {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(share * angle_, axis_).toRotationMatrix();
  Eigen::Matrix4d part = Eigen::Matrix4d::Identity();
  part.topLeftCorner<3, 3>() = turn;
  part.topRightCorner<3, 1>() = centre_ - turn * centre_ + share * slide_;
  return part;
}

}  // namespace musclewarp
