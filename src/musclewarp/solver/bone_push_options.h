// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace musclewarp {

// How bones push muscles aside (bone_push.h). benchmarks/push_options.cc tells
// what halving and doubling the numbers does. Lengths are in mm, and suit
// people.
struct BonePushOptions {
  // If false, bones are left to contact.
  bool enabled = true;

  // What samples of a muscle keep from bones, unless they are nearer at rest.
  double clearance = 1;

  // The way into the clearance over which forces begin.
  double onset = 1;

  // How stiff bones are against what the mean sample resists.
  double relative_stiffness = 40;

  // m: how the push is held back in a step, against the energy of the shape.
  double drag = 1;

  // How far a push that is held back may be from the least energy, which it
  // goes on to in the pose itself.
  double max_lag = 3;

  // Samples of a muscle by vertex of its hull.
  int samples_per_coarse_vertex = 4;

  // The steps from one pose of the way to the next (WayFromRest).
  int steps_per_pose = 8;

  // The spacing of the distance fields of bones.
  double field_spacing = 3;

  bool IsValid(std::string* error) const;
};

}  // namespace musclewarp
