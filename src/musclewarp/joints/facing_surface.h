// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/joints/surface_points.h"

namespace musclewarp {

// What counts as looking at another bone.
struct FacingLimits {
  double reach = 6;               // mm, to the other bone
  double least_cosine = 0.7;      // of the normal and the way to it
  double least_opposition = 0.5;  // of both normals, by their cosine
};

// Returns the points of a bone that look at another one across a joint: whose
// nearest point on the other bone is within reach, along the normal, with the
// opposite normal. Cartilage keeps bones 2 to 5 mm apart. Both bones must be
// from one image.
SurfacePoints FacingSurface(const SurfacePoints& bone,
                            const SurfacePoints& other,
                            const FacingLimits& limits = {});

}  // namespace musclewarp
