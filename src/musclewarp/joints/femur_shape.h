// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "musclewarp/joints/cylinder_fit.h"

namespace musclewarp {

// The directions of a long bone, of unit length and at right angles, as far as
// its shape alone tells them.
struct BoneDirections {
  Axis shaft;          // upwards
  Eigen::Vector3d up;  // of the shaft
  Eigen::Vector3d back;
  Eigen::Vector3d left;  // back x up, the left of the body

  // How far the lower end reaches back from the line of the shaft, by how far
  // it reaches forward.
  double back_to_front = 0;

  // The lowest place of the bone: its height along `up` from the origin, mm.
  double lowest = 0;
};

// Returns the line along a long bone: through the middles of its slices between
// 30 and 70 % of its length, upwards if `up` has a positive component along it.
Axis ShaftOf(const SurfacePoints& bone, const Eigen::Vector3d& up);

// Tells the directions of a femur of which the line of the shaft is known,
// upwards: left and right are along the widest direction of the lower end, and
// back is the side on which the condyles reach farther from the shaft.
// `head_radius` (mm) scales what counts as the lower end.
BoneDirections DirectionsOfFemur(const SurfacePoints& femur,
                                 const Axis& shaft,
                                 double head_radius);

}  // namespace musclewarp
