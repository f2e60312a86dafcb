// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/random_draws.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>

namespace musclewarp {

double RandomDraws::Uniform(double low, double high) {
  return low + (high - low) * (engine_() / 4294967296.0);
}

int RandomDraws::Integer(int low, int high) {
  CHECK_LE(low, high);
  const double value = std::floor(Uniform(low, high + 1.0));
  return std::min(static_cast<int>(value), high);
}

Eigen::Vector3d RandomDraws::Direction() {
  // A point of the cube that is in the ball, but not near its centre, where
  // the direction would be badly rounded.
  while (true) {
    const double x = Uniform(-1, 1);
    const double y = Uniform(-1, 1);
    const double z = Uniform(-1, 1);
    const Eigen::Vector3d p(x, y, z);
    const double norm = p.norm();
    if (norm > 0.1 && norm <= 1) return p / norm;
  }
}

Eigen::Vector3d RandomDraws::DirectionAcross(const Eigen::Vector3d& direction) {
  while (true) {
    const Eigen::Vector3d p = Direction();
    const Eigen::Vector3d across = p - p.dot(direction) * direction;
    const double norm = across.norm();
    if (norm > 0.1) return across / norm;
  }
}

}  // namespace musclewarp
