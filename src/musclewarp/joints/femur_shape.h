// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "musclewarp/joints/cylinder_fit.h"

namespace musclewarp {

// Orthonormal directions of a long bone, found on its shape alone.
struct BoneDirections {
  Axis shaft;          // upwards
  Eigen::Vector3d up;  // of the shaft
  Eigen::Vector3d back;
  Eigen::Vector3d left;  // back x up, the left of the body

  // The distance by which the lower end extends back from the line of the
  // shaft, divided by the distance by which it extends forward.
  double back_to_front = 0;

  // The lowest place of the bone: its height along `up` from the origin, mm.
  double lowest = 0;
};

// Returns the line along a long bone: through the middles of its slices between
// 30 and 70 % of its length, upwards if `up` has a positive component along it.
Axis ShaftOf(const SurfacePoints& bone, const Eigen::Vector3d& up);

// Returns the directions of a femur with a known shaft, which points upwards:
// left and right are along the widest direction of the lower end, and back is
// the side on which the condyles extend farther from the shaft. `head_radius`
// (mm) scales the height of the lower end.
BoneDirections DirectionsOfFemur(const SurfacePoints& femur,
                                 const Axis& shaft,
                                 double head_radius);

}  // namespace musclewarp
