// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/joints/surface_points.h"

namespace musclewarp {

// The limits of the surface that looks at another bone.
struct FacingLimits {
  double reach = 6;  // mm: cartilage keeps bones 2 to 5 mm apart

  // Least cosine between a normal and the direction to the other bone: within
  // 46 degrees.
  double least_cosine = 0.7;

  // Least cosine between a normal and the opposite of the other one: within 60
  // degrees.
  double least_opposition = 0.5;
};

// Returns the points of a bone that look at another one across a joint: whose
// nearest point on the other bone is within reach, along the normal, with the
// opposite normal. Both bones must be from one image.
SurfacePoints FacingSurface(const SurfacePoints& bone,
                            const SurfacePoints& other,
                            const FacingLimits& limits = {});

}  // namespace musclewarp
