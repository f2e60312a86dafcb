// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/facing_surface.h"

#include <vector>

#include "musclewarp/joints/point_search.h"

namespace musclewarp {

SurfacePoints FacingSurface(const SurfacePoints& bone,
                            const SurfacePoints& other,
                            const FacingLimits& limits) {
  const PointSearch search(other.points);
  std::vector<char> is_facing(bone.size(), false);
#pragma omp parallel for schedule(dynamic, 256)
  for (int i = 0; i < bone.size(); ++i) {
    const Eigen::RowVector3d point = bone.points.row(i);
    const int nearest = search.Nearest(point);
    if (nearest < 0) continue;
    const Eigen::RowVector3d way = other.points.row(nearest) - point;
    const double distance = way.norm();
    const Eigen::RowVector3d normal = bone.normals.row(i);
    is_facing[i] =
        distance <= limits.reach &&
        way.dot(normal) >= limits.least_cosine * distance &&
        other.normals.row(nearest).dot(normal) <= -limits.least_opposition;
  }
  return Filtered(bone, [&](int row) { return is_facing[row]; });
}

}  // namespace musclewarp
