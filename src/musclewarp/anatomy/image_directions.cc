// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/anatomy/image_directions.h"

#include <glog/logging.h>

namespace musclewarp {

Eigen::Matrix3d DirectionsOfAxes(const std::string& axes) {
  CHECK_EQ(axes.size(), 3u);
  Eigen::Matrix3d directions = Eigen::Matrix3d::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    switch (axes[axis]) {
      case 'A':
      case 'P':
        directions(axis, 0) = axes[axis] == 'A' ? 1 : -1;
        break;
      case 'S':
      case 'I':
        directions(axis, 1) = axes[axis] == 'S' ? 1 : -1;
        break;
      case 'R':
      case 'L':
        directions(axis, 2) = axes[axis] == 'R' ? 1 : -1;
        break;
      default:
        LOG(FATAL) << "no axes: " << axes;
    }
  }
  return directions;
}

}  // namespace musclewarp
