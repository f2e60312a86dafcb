// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/solid_distance.h"

#include <algorithm>

#include "musclewarp/base/infinity.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// Of the samples, mm. Finer ones take longer to compute than they save.
constexpr double kSpacing = 3;

double SearchedDistance(const SearchableMesh& mesh, const RowVector3d& p) {
  const double distance = mesh.bvh().ClosestPoint(p, kInfinity).distance;
  return mesh.bvh().box().Contains(p) && mesh.winding().IsInside(p) ? -distance
                                                                    : distance;
}

}  // namespace

SolidDistance::SolidDistance(const SearchableMesh& mesh)
    : mesh_(mesh),
      samples_([&](const RowVector3d& p) { return SearchedDistance(mesh, p); },
               mesh.bvh().box(),
               kSpacing) {}

double SolidDistance::At(const RowVector3d& p, double limit) const {
  bool is_inside = false, is_known = false;
  const std::int64_t nearest = samples_.NearestTo(p);
  if (nearest >= 0) {
    // A way shorter than the distance does not reach the surface.
    const double sample = samples_.value(nearest);
    const double way = (p - samples_.Position(nearest)).norm();
    if (sample - way >= limit) return limit;
    is_known = way < std::abs(sample);
    is_inside = sample < 0;
  }
  if (!is_known) {
    is_inside = mesh_.bvh().box().Contains(p) && mesh_.winding().IsInside(p);
  }
  const double distance =
      mesh_.bvh().ClosestPoint(p, is_inside ? kInfinity : limit).distance;
  return is_inside ? -distance : std::min(distance, limit);
}

}  // namespace musclewarp
