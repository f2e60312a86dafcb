// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certificate/containment.h"

#include <algorithm>
#include <optional>

#include "musclewarp/cgal/exact_predicates.h"
#include "musclewarp/cgal/triangle_intersection.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// Returns how often the segment from p, which lies on no triangle, to q leaves
// the mesh, less how often it enters it, or nothing if it meets an edge or a
// corner.
std::optional<int> CountCrossings(const RowVector3d& p,
                                  const RowVector3d& q,
                                  const BoxedMesh& mesh) {
  const RoundedBox box = RoundedBoxOf(p.cwiseMin(q), p.cwiseMax(q));
  int winding = 0;
  for (int cluster = 0; cluster < mesh.clusters().size(); ++cluster) {
    if (!mesh.cluster_boxes()[cluster].Overlaps(box)) continue;
    for (const int* f = mesh.clusters().begin(cluster);
         f < mesh.clusters().end(cluster);
         ++f) {
      const Corners triangle = mesh.corners(*f);
      if (!RoundedBoxOf(triangle).Overlaps(box)) continue;
      const RowVector3d a = triangle.row(0), b = triangle.row(1),
                        c = triangle.row(2);
      const int side_p = Orientation(a, b, c, p);
      const int side_q = Orientation(a, b, c, q);
      if (side_p == side_q && side_p != 0) continue;
      const int ab = Orientation(p, q, a, b);
      const int bc = Orientation(p, q, b, c);
      const int ca = Orientation(p, q, c, a);
      if (std::min({ab, bc, ca}) < 0 && std::max({ab, bc, ca}) > 0) continue;
      if (side_p == 0 || side_q == 0 || ab == 0 || bc == 0 || ca == 0) {
        return std::nullopt;
      }
      winding += side_p > 0 ? 1 : -1;
    }
  }
  return winding;
}

bool IsOnSurface(const RowVector3d& p, const BoxedMesh& mesh) {
  for (Eigen::Index f = 0; f < mesh.num_triangles(); ++f) {
    if (IsOnTriangle(p, mesh.corners(f))) return true;
  }
  return false;
}

}  // namespace

bool IsInsideClosed(const RowVector3d& point, const BoxedMesh& mesh) {
  if (!mesh.box().Overlaps(RoundedBoxOf(point, point))) return false;
  double beyond = 1;
  for (int k = 0; k < 3; ++k) {
    beyond += static_cast<double>(mesh.box().upper[k]) - mesh.box().lower[k];
  }
  // Nearly along x: boxes then exclude almost all triangles. A tilt that meets
  // an edge is not met again.
  constexpr int kAttempts = 30;
  double tilt = 0.001;
  for (int attempt = 0; attempt < kAttempts; ++attempt, tilt *= 1.37) {
    const RowVector3d end =
        point + beyond * RowVector3d(1, tilt, -0.618 * tilt);
    const std::optional<int> winding = CountCrossings(point, end, mesh);
    if (winding) return *winding != 0;
    if (attempt == 0 && IsOnSurface(point, mesh)) return false;
  }
  return true;
}

}  // namespace musclewarp
