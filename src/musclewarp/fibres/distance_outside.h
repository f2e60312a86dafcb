// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/base/infinity.h"
#include "musclewarp/proximity/triangle_bvh.h"

namespace musclewarp {

// Where a point lies beside closed meshes.
struct PlaceBeside {
  double distance = kInfinity;  // mm; negative inside a mesh

  // The direction of unit length in which the distance grows.
  Eigen::RowVector3d outward = Eigen::RowVector3d::Zero();
};

// Returns where a point lies beside the nearest of several closed meshes; at an
// infinite distance if there are none.
PlaceBeside PlaceBesideMeshes(const std::vector<const TriangleBvh*>& meshes,
                              const Eigen::RowVector3d& point);

// Returns the distance (mm) from a point to the nearest of several closed
// meshes: zero inside a mesh, infinity if there are none.
double DistanceOutside(const std::vector<const TriangleBvh*>& meshes,
                       const Eigen::RowVector3d& point);

}  // namespace musclewarp
