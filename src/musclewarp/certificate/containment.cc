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

// Crossings of the segment from p to q with triangles that may be near it.
Parity CountCrossings(const RowVector3d& p,
                      const RowVector3d& q,
                      const SurfaceView& mesh) {
  const RowVector3d lower = p.cwiseMin(q), upper = p.cwiseMax(q);
  bool is_odd = false;
  for (Eigen::Index f = 0; f < mesh.triangles->rows(); ++f) {
    const RowVector3d a = mesh.points->row((*mesh.triangles)(f, 0));
    const RowVector3d b = mesh.points->row((*mesh.triangles)(f, 1));
    const RowVector3d c = mesh.points->row((*mesh.triangles)(f, 2));
    bool is_beside = false;
    for (int k = 0; k < 3; ++k) {
      is_beside |= std::max({a[k], b[k], c[k]}) < lower[k] ||
                   std::min({a[k], b[k], c[k]}) > upper[k];
    }
    if (is_beside) continue;
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
  return is_odd ? Parity::kOdd : Parity::kEven;
}

bool IsOnSurface(const RowVector3d& p, const SurfaceView& mesh) {
  for (Eigen::Index f = 0; f < mesh.triangles->rows(); ++f) {
    Corners t;
    for (int k = 0; k < 3; ++k) {
      t.row(k) = mesh.points->row((*mesh.triangles)(f, k));
    }
    if (IsOnTriangle(p, t)) return true;
  }
  return false;
}

}  // namespace

bool IsInsideClosed(const RowVector3d& point, const SurfaceView& mesh) {
  const RowVector3d lower = mesh.points->colwise().minCoeff();
  const RowVector3d upper = mesh.points->colwise().maxCoeff();
  if ((point.array() < lower.array()).any() ||
      (point.array() > upper.array()).any()) {
    return false;
  }
  const double beyond = (upper - lower).norm() + 1;
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
