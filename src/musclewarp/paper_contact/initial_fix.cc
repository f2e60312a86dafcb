// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/paper_contact/initial_fix.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "musclewarp/mesh/measures.h"
#include "musclewarp/paper_contact/regions.h"

namespace musclewarp {
namespace {

// Moves the vertices of a region inside `other` along one direction, each by
// `share` of its way to the surface and the clearance.
void MoveRegion(const Region& region,
                const Eigen::RowVector3d& direction,
                double share,
                double clearance,
                const ContactBody& other,
                Points* points) {
  const double length = direction.norm();
  if (!(length > 0)) return;
  const Eigen::RowVector3d unit = direction / length;
  for (const int v : region.vertices) {
    const double way = other.DistanceAlong(points->row(v), unit);
    if (std::isfinite(way)) points->row(v) += (share * way + clearance) * unit;
  }
}

// Returns the mean outward normal of a region, of any length. The volume
// gradient at a vertex is its normal times a third of the area around it, so
// that large triangles count more.
Eigen::RowVector3d MeanNormal(const Region& region,
                              const Points& volume_gradient) {
  Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
  for (const int v : region.vertices) sum += volume_gradient.row(v);
  return sum;
}

// Returns the points of `body` with its regions moved out of `other`.
// `direction_of[i]` is the direction of a paired region and zero for an
// unpaired one.
Points MovedOut(const std::vector<Region>& regions,
                const std::vector<Eigen::RowVector3d>& direction_of,
                const PaperContactOptions& options,
                const ContactBody& body,
                const ContactBody& other) {
  const double paired_fraction =
      other.is_deformable() ? options.deformable_fraction : 1;
  const Points outward = VolumeGradient(body.points(), body.shape().triangles);
  Points points = body.points();
  for (size_t i = 0; i < regions.size(); ++i) {
    const bool is_paired = !direction_of[i].isZero(0);
    MoveRegion(regions[i],
               is_paired ? direction_of[i] : -MeanNormal(regions[i], outward),
               is_paired ? paired_fraction : 1,
               options.clearance,
               other,
               &points);
  }
  return points;
}

}  // namespace

bool FixInitialIntersections(const PaperContactOptions& options,
                             ContactBody* a,
                             ContactBody* b) {
  const std::vector<Region> regions_a = ConnectedRegions(
      b->Inside(a->points()), a->points(), a->shape().triangles);
  const std::vector<Region> regions_b = ConnectedRegions(
      a->Inside(b->points()), b->points(), b->shape().triangles);
  if (regions_a.empty() && regions_b.empty()) return false;

  const double radius =
      std::min(a->shape().bounding_radius, b->shape().bounding_radius);
  using Directions = std::vector<Eigen::RowVector3d>;
  Directions direction_a(regions_a.size(), Eigen::RowVector3d::Zero());
  Directions direction_b(regions_b.size(), Eigen::RowVector3d::Zero());
  for (const auto& [i, j] :
       PairRegions(regions_a, regions_b, options.pairing_fraction * radius)) {
    direction_a[i] = regions_b[j].centre - regions_a[i].centre;
    direction_b[j] = -direction_a[i];
  }

  // All ways are measured before either body moves.
  Points moved_a, moved_b;
  if (a->is_deformable()) {
    moved_a = MovedOut(regions_a, direction_a, options, *a, *b);
  }
  if (b->is_deformable()) {
    moved_b = MovedOut(regions_b, direction_b, options, *b, *a);
  }
  if (a->is_deformable()) a->MoveTo(std::move(moved_a));
  if (b->is_deformable()) b->MoveTo(std::move(moved_b));
  return true;
}

}  // namespace musclewarp
