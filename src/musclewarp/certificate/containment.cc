// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certificate/containment.h"

#include <algorithm>

#include "musclewarp/proximity/exact_predicates.h"
#include "musclewarp/proximity/triangle_intersection.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

enum class Parity { kEven, kOdd, kUndecided };

// Crossings of the segment from p to q with the triangles that may be near it.
Parity CountCrossings(const RowVector3d& p,
                      const RowVector3d& q,
                      const BoxedMesh& mesh) {
  const RoundedBox box = RoundedBoxOf(p.cwiseMin(q), p.cwiseMax(q));
  bool is_odd = false;
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
        return Parity::kUndecided;
      }
      is_odd = !is_odd;
    }
  }
  return is_odd ? Parity::kOdd : Parity::kEven;
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
    const Parity parity = CountCrossings(point, end, mesh);
    if (parity != Parity::kUndecided) return parity == Parity::kOdd;
    if (attempt == 0 && IsOnSurface(point, mesh)) return false;
  }
  return true;
}

}  // namespace musclewarp
