// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace musclewarp {

// How bones push muscles aside (bone_push.h). docs/method.md has what halving
// and doubling the numbers does. Lengths are in mm, and suit people.
struct BonePushOptions {
  // If false, bones are left to contact.
  bool enabled = true;

  // What samples of a muscle keep from bones, unless they are nearer at rest.
  double clearance = 1;

  // The depth in the clearance by which a force has come to its full stiffness.
  double onset = 1;

  // The stiffness of bones, in multiples of that of the mean sample.
  double relative_stiffness = 40;

  // The weight m of the change in a step, which holds the push back.
  double drag = 1;

  // In the pose itself the push goes on to the least energy, at most this far.
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
