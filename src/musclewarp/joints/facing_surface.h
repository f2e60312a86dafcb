// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/joints/surface_points.h"

namespace musclewarp {

// What counts as looking at another bone (joint_search.h says why).
struct FacingLimits {
  double reach = 6;  // mm
  double least_cosine = 0.7;
  double least_opposition = 0.5;
};

// Returns the points of a bone that look at another one across a joint: whose
// nearest point on the other bone is within reach, along the normal, with the
// opposite normal. Both bones must be from one image.
SurfacePoints FacingSurface(const SurfacePoints& bone,
                            const SurfacePoints& other,
                            const FacingLimits& limits = {});

}  // namespace musclewarp
