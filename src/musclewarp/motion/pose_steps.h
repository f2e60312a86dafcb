// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/base/angles.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Limits on the motion of bodies and lines in one step, which keep bones from
// passing through muscles between two steps.
struct StepLimits {
  double max_turn = RadiansOf(5);  // of a body, rad
  double max_move = 10;            // of a point of a line, mm

  bool IsValid(std::string* error) const;
};

// Returns the largest motion between two poses, of any body or line, in units
// of the limits.
double WayBetween(const Scene& scene,
                  const ScenePose& from,
                  const ScenePose& to,
                  const StepLimits& limits);

// Returns the number of steps from one pose to another within the limits, at
// least 1.
int StepsBetween(const Scene& scene,
                 const ScenePose& from,
                 const ScenePose& to,
                 const StepLimits& limits);

}  // namespace musclewarp
