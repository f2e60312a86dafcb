// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace musclewarp {

// A rigid motion as a rotation about an axis in space and a translation along
// that axis, for interpolation between two poses of a body. Every rigid motion
// is such a screw motion (Chasles' theorem). Parts of a rotation about a joint
// are rotations about the same joint, whereas interpolating rotation and
// translation separately would move the head of the bone out of its socket on
// the way.
class ScrewMotion {
 public:
  // Takes a rigid motion (mm). A rotation by less than 1e-9 rad counts as none.
  explicit ScrewMotion(const Eigen::Matrix4d& motion);

  // Returns a part of the motion: the rotation angle and the translation times
  // `share`, which is 0 for the identity and 1 for the whole motion.
  Eigen::Matrix4d Part(double share) const;

 private:
  Eigen::Vector3d axis_;    // of unit length
  Eigen::Vector3d centre_;  // on the axis, mm
  Eigen::Vector3d slide_;   // mm
  double angle_;            // rad
};

}  // namespace musclewarp
