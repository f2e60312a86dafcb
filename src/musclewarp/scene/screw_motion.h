// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace musclewarp {

// A rigid motion as a turn about an axis in space and a slide along it. Every
// rigid motion is one (Chasles); a turn about a joint stays one in all its
// parts, which it would not if rotation and translation went on their own.
class ScrewMotion {
 public:
  // `motion` is rigid, mm.
  explicit ScrewMotion(const Eigen::Matrix4d& motion);

  // The part `share` of the motion; 0 is the identity, 1 the motion.
  Eigen::Matrix4d Part(double share) const;

 private:
  Eigen::Vector3d axis_;    // of unit length
  Eigen::Vector3d centre_;  // on the axis, mm
  Eigen::Vector3d slide_;   // mm
  double angle_;            // rad
};

}  // namespace musclewarp
