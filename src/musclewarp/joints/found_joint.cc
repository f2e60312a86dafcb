// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/found_joint.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <cmath>

namespace musclewarp {

std::string ToString(JointQuality quality) {
  switch (quality) {
    case JointQuality::kGood:
      return "good";
    case JointQuality::kWeak:
      return "weak";
    case JointQuality::kFailed:
      return "failed";
  }
  return "";
}

void JointVerdict::Weaken(const std::string& reason) {
  if (quality == JointQuality::kGood) quality = JointQuality::kWeak;
  reasons.push_back(reason);
}

void JointVerdict::Fail(const std::string& reason) {
  quality = JointQuality::kFailed;
  reasons.push_back(reason);
}

std::vector<double> ScanCoordinates(const FoundJoint& joint) {
  const std::vector<JointCoordinate> coordinates =
      CoordinatesOf(joint.kind, joint.side);
  const Eigen::Matrix3d child_in_parent =
      joint.parent_axes.transpose() * joint.child_axes;
  if (coordinates.size() == 1) {
    const Eigen::AngleAxisd turn(child_in_parent);
    return {turn.angle() * turn.axis().dot(coordinates[0].axis)};
  }
  CHECK_EQ(coordinates.size(), 3);
  // R = Rz(a) Rx(b) Ry(c); axes of the table may be reversed.
  const Eigen::Matrix3d& r = child_in_parent;
  const double b = std::asin(std::min(1.0, std::max(-1.0, r(2, 1))));
  const double a = std::atan2(-r(0, 1), r(1, 1));
  const double c = std::atan2(-r(2, 0), r(2, 2));
  return {a * coordinates[0].axis.z(),
          b * coordinates[1].axis.x(),
          c * coordinates[2].axis.y()};
}

}  // namespace musclewarp
