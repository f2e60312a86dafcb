// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "musclewarp/certificate/crossing_triangles.h"

namespace musclewarp {

// Whether a point is inside a closed mesh: segments from it to a place outside
// cross the surface an odd number of times, counted by exact predicates. A
// segment that meets an edge or a corner is left for another. A point on the
// surface is not inside. Where no segment can tell, it counts as inside: what
// is not proved is not claimed.
bool IsInsideClosed(const Eigen::RowVector3d& point, const SurfaceView& mesh);

}  // namespace musclewarp
