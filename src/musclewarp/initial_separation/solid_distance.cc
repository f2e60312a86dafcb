// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/initial_separation/solid_distance.h"

#include <algorithm>

#include "musclewarp/base/infinity.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// The spacing of the samples, mm.
constexpr double kSpacing = 3;

double SearchedDistance(const SearchableMesh& mesh, const RowVector3d& p) {
  const double distance = mesh.bvh().ClosestPoint(p, kInfinity).distance;
  return mesh.bvh().box().Contains(p) && mesh.winding().IsInside(p) ? -distance
                                                                    : distance;
}

// Returns true if a sample is the exact distance. Other samples are smaller in
// magnitude than the distance.
bool IsExact(double sample) { return std::abs(sample) <= 2 * kSpacing; }

}  // namespace

SolidDistance::SolidDistance(const SearchableMesh& mesh)
    : mesh_(mesh),
      samples_(
          [&mesh](const RowVector3d& p) { return SearchedDistance(mesh, p); },
          mesh.bvh().box(),
          kSpacing) {}

double SolidDistance::At(const RowVector3d& p, double limit) const {
  const TriangleBvh& tree = mesh_.bvh();
  const std::int64_t nearest = samples_.NearestTo(p);
  // The samples cover more than the box of the mesh.
  if (nearest < 0) return std::min(tree.ClosestPoint(p, limit).distance, limit);
  const double sample = samples_.value(nearest);
  const double way = (p - samples_.Position(nearest)).norm();
  if (sample - way >= limit) return limit;
  // An exact sample bounds the distance to the surface from above. A margin
  // above rounding ensures that the nearest triangle is found.
  constexpr double kMargin = 1e-9;
  double farthest = kInfinity;
  if (IsExact(sample)) {
    farthest = (std::abs(sample) + way) * (1 + kMargin) + kMargin;
  }
  // A path shorter than the distance does not reach the surface.
  if (sample > way) farthest = std::min(farthest, limit);
  const double distance = tree.ClosestPoint(p, farthest).distance;
  // Nor does one that is shorter than the distances of both ends together.
  const bool is_inside =
      std::abs(sample) + distance > way * (1 + kMargin) + kMargin
          ? sample < 0
          : tree.box().Contains(p) && mesh_.winding().IsInside(p);
  return is_inside ? -distance : std::min(distance, limit);
}

double SolidDistance::UpperBound(const RowVector3d& p) const {
  const std::int64_t nearest = samples_.NearestTo(p);
  if (nearest < 0) return kInfinity;
  const double sample = samples_.value(nearest);
  if (sample > 0 && !IsExact(sample)) return kInfinity;
  return sample + (p - samples_.Position(nearest)).norm();
}

}  // namespace musclewarp
