// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/proximity/triangle_distance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// Has no branches, since processors could not predict them.
double Clamped(double x) { return std::min(std::max(x, 0.0), 1.0); }

RowVector3d ClosestPointOfSegment(const RowVector3d& p,
                                  const RowVector3d& a,
                                  const RowVector3d& b) {
  const RowVector3d ab = b - a;
  const double along = ab.dot(p - a);
  const double square = ab.squaredNorm();
  if (!(along > 0)) return a;
  if (along >= square) return b;
  return a + along / square * ab;
}

// The edges of a triangle, from corner i to the next one.
struct Edges {
  RowVector3d from[3], along[3];
  double square[3], inverse[3];  // squared lengths; 1 over them, or 0

  explicit Edges(const Corners& t) {
    for (int i = 0; i < 3; ++i) {
      from[i] = t.row(i);
      along[i] = t.row((i + 1) % 3) - t.row(i);
      square[i] = along[i].squaredNorm();
      inverse[i] = square[i] > 0 ? 1 / square[i] : 0;
    }
  }

  // Finds the foot of a point on the plane of the triangle. `at_first` and
  // `at_last` are the products of its offset from corner 0 with the edges from
  // there to corners 1 and 2. Returns false if the foot is not inside the
  // triangle.
  bool Foot(double at_first, double at_last, RowVector3d* foot) const {
    const double mixed = -along[0].dot(along[2]);
    const double determinant = square[0] * square[2] - mixed * mixed;
    const double u = at_first * square[2] - at_last * mixed;
    const double v = at_last * square[0] - at_first * mixed;
    if (!(u > 0 && v > 0 && u + v < determinant)) return false;
    *foot = from[0] + u / determinant * along[0] - v / determinant * along[2];
    return true;
  }
};

}  // namespace

RowVector3d ClosestPointOfTriangle(const RowVector3d& p,
                                   const Corners& triangle) {
  const RowVector3d a = triangle.row(0);
  const RowVector3d b = triangle.row(1);
  const RowVector3d c = triangle.row(2);
  // Barycentric coordinates of the foot of p on the plane, times |n|^2.
  const RowVector3d n = (b - a).cross(c - a);
  const double at_b = n.dot((p - a).cross(c - a));
  const double at_c = n.dot((b - a).cross(p - a));
  const double square = n.squaredNorm();
  const double at_a = square - at_b - at_c;
  const bool is_above = at_a > 0 && at_b > 0 && at_c > 0;
  const RowVector3d foot =
      is_above
          ? RowVector3d(a + at_b / square * (b - a) + at_c / square * (c - a))
          : RowVector3d(RowVector3d::Constant(
                std::numeric_limits<double>::quiet_NaN()));
  // With a sine below 1e-6 the foot may lie in the triangle and yet not be the
  // closest point; one of the edges has a point as close then.
  const bool is_needle =
      square < 1e-12 * (b - a).squaredNorm() * (c - a).squaredNorm();
  if (is_above && !is_needle) return foot;

  RowVector3d closest = ClosestPointOfSegment(p, a, b);
  double least = (p - closest).squaredNorm();
  const auto offer = [&](const RowVector3d& candidate) {
    const double distance = (p - candidate).squaredNorm();
    if (distance < least) {
      least = distance;
      closest = candidate;
    }
  };
  offer(ClosestPointOfSegment(p, b, c));
  offer(ClosestPointOfSegment(p, c, a));
  if (is_above) offer(foot);
  return closest;
}

ClosestPair ClosestPointsOfTriangles(const Corners& a, const Corners& b) {
  const Edges d(a), e(b);
  // Products of edges and of the offsets r_ij = a_i - b_j with them.
  double dr[3][3], er[3][3];
  // Find the nearest two edges by products alone, whose rounding errors are
  // relative to the size of the triangles, and the points for these edges only.
  double least = std::numeric_limits<double>::infinity();
  double best_s = 0, best_t = 0;
  int best_i = 0, best_j = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const RowVector3d r = d.from[i] - e.from[j];
      const double de = d.along[i].dot(e.along[j]);
      dr[i][j] = d.along[i].dot(r);
      er[i][j] = e.along[j].dot(r);
      // Go from where the lines are closest to where the segments are. Parallel
      // lines are equally close everywhere.
      const double determinant = d.square[i] * e.square[j] - de * de;
      const double inverse = determinant > 0 ? 1 / determinant : 0;
      const double s_of_lines =
          Clamped((de * er[i][j] - dr[i][j] * e.square[j]) * inverse);
      const double t = Clamped((de * s_of_lines + er[i][j]) * e.inverse[j]);
      const double s = Clamped((de * t - dr[i][j]) * d.inverse[i]);
      const double square = r.squaredNorm() +
                            s * (s * d.square[i] + 2 * dr[i][j]) +
                            t * (t * e.square[j] - 2 * er[i][j] - 2 * s * de);
      if (square < least) {
        least = square;
        best_s = s;
        best_t = t;
        best_i = i;
        best_j = j;
      }
    }
  }
  ClosestPair closest;
  closest.squared_distance = std::numeric_limits<double>::infinity();
  const auto offer = [&](const RowVector3d& on_a, const RowVector3d& on_b) {
    const double square = (on_a - on_b).squaredNorm();
    if (square < closest.squared_distance) closest = {on_a, on_b, square};
  };
  offer(d.from[best_i] + best_s * d.along[best_i],
        e.from[best_j] + best_t * e.along[best_j]);
  // Or a corner may be closest to a point inside the other triangle. All other
  // cases are pairs of points on the borders.
  RowVector3d foot;
  for (int i = 0; i < 3; ++i) {
    if (e.Foot(er[i][0], e.square[2] - er[i][2], &foot)) {
      offer(d.from[i], foot);
    }
    if (d.Foot(-dr[0][i], d.square[2] + dr[2][i], &foot)) {
      offer(foot, e.from[i]);
    }
  }
  return closest;
}

}  // namespace musclewarp
