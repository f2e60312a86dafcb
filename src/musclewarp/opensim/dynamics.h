// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <map>
#include <string>

#include "musclewarp/opensim/model.h"

namespace musclewarp {

// What a model says of masses and forces, which the motion of its bodies and
// muscle paths does not depend on. Numbers that the file does not have are 0.

// The mass of a body, in its frame.
struct BodyMass {
  double mass = 0;                                   // kg
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  // mm

  // The moments of inertia about the centre, kg m^2: xx, yy, zz, xy, xz, yz.
  std::array<double, 6> inertia = {0, 0, 0, 0, 0, 0};
};

struct MuscleDynamics {
  double force = 0;   // max_isometric_force, N
  double tendon = 0;  // tendon_slack_length, mm
};

// By the names of bodies and muscles.
struct ModelDynamics {
  std::map<std::string, BodyMass> bodies;
  std::map<std::string, MuscleDynamics> muscles;
};

// Returns the masses and forces of a model, from its text. Throws InputError at
// the element for what should be a number and is none.
ModelDynamics DynamicsOf(const Model& model);

}  // namespace musclewarp
