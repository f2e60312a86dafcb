// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/triangle_distance.h"

#include <algorithm>
#include <limits>

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

double Clamped(double x) { return std::clamp(x, 0.0, 1.0); }

// The places s on the segment p + s d and t on q + t e closest to each other.
// Degenerate segments are points.
void ClosestOnSegments(const RowVector3d& p,
                       const RowVector3d& d,
                       const RowVector3d& q,
                       const RowVector3d& e,
                       double* s,
                       double* t) {
  const RowVector3d r = p - q;
  const double dd = d.squaredNorm();
  const double ee = e.squaredNorm();
  const double de = d.dot(e);
  const double dr = d.dot(r);
  const double er = e.dot(r);
  const double determinant = dd * ee - de * de;
  *s = determinant > 0 ? Clamped((de * er - dr * ee) / determinant) : 0;
  *t = ee > 0 ? (de * *s + er) / ee : 0;
  if (*t < 0 || *t > 1 || ee == 0) {
    *t = Clamped(*t);
    *s = dd > 0 ? Clamped((de * *t - dr) / dd) : 0;
  }
}

}  // namespace

ClosestPair ClosestPointsOfTriangles(const Corners& a, const Corners& b) {
  ClosestPair closest;
  closest.squared_distance = std::numeric_limits<double>::infinity();
  const auto offer = [&](const RowVector3d& on_a, const RowVector3d& on_b) {
    const double square = (on_a - on_b).squaredNorm();
    if (square < closest.squared_distance) closest = {on_a, on_b, square};
  };
  for (int i = 0; i < 3; ++i) {
    const RowVector3d p = a.row(i);
    const RowVector3d d = a.row((i + 1) % 3) - a.row(i);
    for (int j = 0; j < 3; ++j) {
      const RowVector3d q = b.row(j);
      const RowVector3d e = b.row((j + 1) % 3) - b.row(j);
      double s, t;
      ClosestOnSegments(p, d, q, e, &s, &t);
      offer(p + s * d, q + t * e);
    }
  }
  // A corner over the inside of the other triangle; all other places of a
  // corner are on the borders.
  const auto over_inside = [](const RowVector3d& p,
                              const Corners& triangle,
                              RowVector3d* foot) {
    const RowVector3d u = triangle.row(1) - triangle.row(0);
    const RowVector3d v = triangle.row(2) - triangle.row(0);
    const RowVector3d w = p - triangle.row(0);
    const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v);
    const double uw = u.dot(w), vw = v.dot(w);
    const double determinant = uu * vv - uv * uv;
    const double at_u = uw * vv - vw * uv;
    const double at_v = vw * uu - uw * uv;
    if (!(at_u > 0 && at_v > 0 && at_u + at_v < determinant)) return false;
    *foot = triangle.row(0) + at_u / determinant * u + at_v / determinant * v;
    return true;
  };
  RowVector3d foot;
  for (int i = 0; i < 3; ++i) {
    const RowVector3d p = a.row(i);
    const RowVector3d q = b.row(i);
    if (over_inside(p, b, &foot)) offer(p, foot);
    if (over_inside(q, a, &foot)) offer(foot, q);
  }
  return closest;
}

}  // namespace musclewarp
