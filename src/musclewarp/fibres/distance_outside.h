// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/proximity/triangle_bvh.h"

namespace musclewarp {

// Returns the distance (mm) from a point to the nearest of several closed
// meshes: zero inside a mesh, infinity if there are none.
double DistanceOutside(const std::vector<const TriangleBvh*>& meshes,
                       const Eigen::RowVector3d& point);

}  // namespace musclewarp
