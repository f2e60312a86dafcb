// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/proximity/winding_number.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "musclewarp/cgal/exact_predicates.h"
#include "musclewarp/cgal/triangle_intersection.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// Points are treated as if they were moved by (e, e^2, e^3) with a sufficiently
// small e > 0. Every sign below is that of the moved point, so that rays never
// meet an edge, and shared edges and vertices are counted once.

int Sign(double value) { return (value > 0) - (value < 0); }

// Returns the side of the line ab, seen along z, on which p lies.
int SideOfEdge(const RowVector3d& a,
               const RowVector3d& b,
               const RowVector3d& p) {
  const int side = Orientation2d(a[0], a[1], b[0], b[1], p[0], p[1]);
  if (side != 0) return side;
  return a[1] != b[1] ? Sign(a[1] - b[1]) : Sign(b[0] - a[0]);
}

// Returns the side of the triangle's plane on which p lies, or 0 for a triangle
// without area.
int SideOfPlane(const Corners& t, const RowVector3d& p) {
  const int side = Orientation(t.row(0), t.row(1), t.row(2), p);
  if (side != 0) return side;
  for (int axis = 0; axis < 3; ++axis) {
    const int y = (axis + 1) % 3;
    const int z = (axis + 2) % 3;
    const int normal =
        Orientation2d(t(0, y), t(0, z), t(1, y), t(1, z), t(2, y), t(2, z));
    if (normal != 0) return normal;
  }
  return 0;
}

// Returns what a triangle adds to the winding number of a closed surface,
// counted along the ray from p towards +z: 1 where the ray leaves the surface,
// -1 where it enters it, and 0 if it does not meet the triangle.
int SignedCrossing(const Corners& t, const RowVector3d& p) {
  const int side = SideOfEdge(t.row(0), t.row(1), p);
  if (side == 0 || SideOfEdge(t.row(1), t.row(2), p) != side ||
      SideOfEdge(t.row(2), t.row(0), p) != side) {
    return 0;
  }
  return SideOfPlane(t, p) == -side ? side : 0;
}

// A solid angle whose conditioning is above this is accurate: its error is
// about 1e-16 over the conditioning, which is 1 far away from the triangle and
// 0 on its edges.
constexpr double kWellConditioned = 1e-5;

struct SolidAngle {
  double turns;         // over 4 pi
  double conditioning;  // see above
};

// The formula is that of van Oosterom and Strackee 1983. The sign is found
// exactly, since a wrong one beside the plane would be an error of a whole
// turn.
SolidAngle SolidAngleOf(const Corners& t, const RowVector3d& p) {
  const int side = SideOfPlane(t, p);
  if (side == 0) return {0, 1};
  const RowVector3d a = t.row(0) - p;
  const RowVector3d b = t.row(1) - p;
  const RowVector3d c = t.row(2) - p;
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  const double sine = std::abs(a.dot(b.cross(c)));
  const double cosine =
      la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
  const double size = la * lb * lc;
  return {-side * std::atan2(sine, cosine) / (2 * M_PI),
          size > 0 ? std::hypot(sine, cosine) / size : 0};
}

}  // namespace

WindingNumber::WindingNumber(const TriangleBvh* bvh, const Triangles& triangles)
    : bvh_(bvh) {
  CHECK_EQ(bvh->num_triangles(), triangles.rows());
  // Sort half-edges by edge, so that those of both directions are neighbours.
  struct Entry {
    int low, high;
    bool is_upward;
    HalfEdge half_edge;
  };
  std::vector<Entry> entries;
  entries.reserve(3 * triangles.rows());
  for (int f = 0; f < triangles.rows(); ++f) {
    for (int corner = 0; corner < 3; ++corner) {
      const int from = triangles(f, corner);
      const int to = triangles(f, (corner + 1) % 3);
      if (from == to) continue;
      entries.push_back({std::min(from, to),
                         std::max(from, to),
                         from < to,
                         HalfEdge{f, corner}});
    }
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& x, const Entry& y) {
    return std::tie(x.low, x.high, x.half_edge.triangle, x.half_edge.corner) <
           std::tie(y.low, y.high, y.half_edge.triangle, y.half_edge.corner);
  });
  for (size_t begin = 0, end = 0; begin < entries.size(); begin = end) {
    int excess = 0;  // upward minus downward
    for (; end < entries.size() && entries[end].low == entries[begin].low &&
           entries[end].high == entries[begin].high;
         ++end) {
      excess += entries[end].is_upward ? 1 : -1;
    }
    const bool is_upward = excess > 0;
    int left = std::abs(excess);
    for (size_t i = begin; i < end && left > 0; ++i) {
      if (entries[i].is_upward != is_upward) continue;
      border_.push_back(entries[i].half_edge);
      --left;
    }
  }
}

WindingNumber::Fan WindingNumber::FanFrom(const RowVector3d& apex,
                                          const RowVector3d& p) const {
  Fan fan;
  Corners triangle;
  triangle.row(0) = apex;
  for (const HalfEdge& edge : border_) {
    const Corners& owner = bvh_->corners(edge.triangle);
    triangle.row(1) = owner.row(edge.corner);
    triangle.row(2) = owner.row((edge.corner + 1) % 3);
    fan.crossings += SignedCrossing(triangle, p);
    const SolidAngle angle = SolidAngleOf(triangle, p);
    fan.turns += angle.turns;
    fan.conditioning = std::min(fan.conditioning, angle.conditioning);
  }
  return fan;
}

WindingNumber::Fan WindingNumber::BorderFan(const RowVector3d& p) const {
  if (border_.empty()) return {};
  const Fan first =
      FanFrom(bvh_->corners(border_[0].triangle).row(border_[0].corner), p);
  if (first.conditioning > kWellConditioned) return first;
  // The point is beside an edge between two triangles of the fan. The result is
  // the same for every apex; this one is not in line with anything likely.
  const Box3& box = bvh_->box();
  RowVector3d apex;
  for (int axis = 0; axis < 3; ++axis) {
    const double share = 0.37 + 0.11 * axis;
    apex[axis] = (1 - share) * box.lower[axis] + share * box.upper[axis];
  }
  const Fan second = FanFrom(apex, p);
  return second.conditioning > first.conditioning ? second : first;
}

double WindingNumber::At(const RowVector3d& p) const {
  int crossings = 0;
  bvh_->Traverse(
      [&](const Box3& box) {
        return (box.lower[0] <= p[0]) & (p[0] <= box.upper[0]) &
               (box.lower[1] <= p[1]) & (p[1] <= box.upper[1]) &
               (p[2] <= box.upper[2]);
      },
      [&](int f) { crossings += SignedCrossing(bvh_->corners(f), p); });
  // The mesh minus the fan is closed, and its winding number is an integer.
  const Fan fan = BorderFan(p);
  return crossings - fan.crossings + fan.turns;
}

bool WindingNumber::IsInside(const RowVector3d& point) const {
  return At(point) > 0.5 && !IsOnSurface(point);
}

bool WindingNumber::IsOnSurface(const RowVector3d& point) const {
  bool is_on = false;
  bvh_->Traverse(
      [&](const Box3& box) { return !is_on && box.Contains(point); },
      [&](int f) { is_on = is_on || IsOnTriangle(point, bvh_->corners(f)); });
  return is_on;
}

}  // namespace musclewarp
