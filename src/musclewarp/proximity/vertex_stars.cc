// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/proximity/vertex_stars.h"

#include <cmath>
#include <utility>

#include "musclewarp/cgal/exact_predicates.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// Rings that are longer are not looked at.
constexpr int kLongestRing = 64;

// Returns the sign of (a x b) . up, or 0 if rounding leaves it open. `a` and
// `b` are differences of points. With e = 2^-53 their coordinates have relative
// errors of e, a component of the cross product at most 4 e times the sum of
// the absolute values of its products, and the dot product adds 3 e, so that
// 10 e is a safe bound.
int CertainSide(const RowVector3d& a,
                const RowVector3d& b,
                const RowVector3d& up) {
  constexpr double kBound = 10 * 0x1p-53;
  double height = 0, size = 0;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const double left = a[i] * b[j], right = a[j] * b[i];
    height += (left - right) * up[k];
    size += (std::abs(left) + std::abs(right)) * std::abs(up[k]);
  }
  const double bound = kBound * size + internal::kUnderflow;
  return height > bound ? 1 : height < -bound ? -1 : 0;
}

// Puts the sides opposite to a vertex, each from one neighbour to the next, in
// order around it. Returns nothing if they are not one ring.
std::vector<int> RingOf(const std::vector<std::pair<int, int>>& sides) {
  std::vector<int> ring;
  for (int next = sides[0].first; ring.size() < sides.size();) {
    ring.push_back(next);
    int after = -1;
    for (const auto& [from, to] : sides) {
      if (from != next) continue;
      if (after >= 0) return {};
      after = to;
    }
    if (after < 0) return {};
    next = after;
    if (next == ring[0]) break;
  }
  const bool is_closed = ring.size() == sides.size() && ring.size() >= 3;
  return is_closed ? ring : std::vector<int>();
}

}  // namespace

VertexRings::VertexRings(const Triangles& triangles, Eigen::Index num_points)
    : first_(num_points + 1, 0) {
  std::vector<std::vector<std::pair<int, int>>> sides(num_points);
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      sides[triangles(f, k)].emplace_back(triangles(f, (k + 1) % 3),
                                          triangles(f, (k + 2) % 3));
    }
  }
  for (Eigen::Index v = 0; v < num_points; ++v) {
    if (sides[v].size() >= 3 && sides[v].size() <= kLongestRing) {
      const std::vector<int> ring = RingOf(sides[v]);
      ring_.insert(ring_.end(), ring.begin(), ring.end());
    }
    first_[v + 1] = static_cast<int>(ring_.size());
  }
}

bool IsProperStar(const VertexRings& rings,
                  const Points& points,
                  int v,
                  const RowVector3d& up) {
  const int* ring = rings.begin(v);
  const int count = static_cast<int>(rings.end(v) - ring);
  if (count == 0) return false;
  const RowVector3d center = points.row(v);
  const RowVector3d first = points.row(ring[0]) - center;
  RowVector3d before = first;
  bool is_opposite = false, is_past_half = false;
  for (int i = 1; i <= count; ++i) {
    const RowVector3d edge =
        i < count ? RowVector3d(points.row(ring[i]) - center) : first;
    if (CertainSide(before, edge, up) <= 0) return false;
    before = edge;
    if (i == count) break;
    // Each edge is less than half a turn after the one before. So they go round
    // once if they are first to the left of the first one, then perhaps one is
    // opposite to it, and then to its right.
    const int side = CertainSide(first, edge, up);
    if (side >= 0 && (is_opposite || is_past_half)) return false;
    is_opposite = side == 0;
    is_past_half = side < 0;
  }
  return is_past_half;
}

std::vector<char> ProperStars(const VertexRings& rings, const Points& points) {
  std::vector<char> is_proper(points.rows(), 0);
#pragma omp parallel for schedule(static)
  for (int v = 0; v < rings.num_vertices(); ++v) {
    const int* ring = rings.begin(v);
    const int count = static_cast<int>(rings.end(v) - ring);
    RowVector3d up = RowVector3d::Zero();
    for (int i = 0; i < count; ++i) {
      const RowVector3d a = points.row(ring[i]) - points.row(v);
      const RowVector3d b = points.row(ring[(i + 1) % count]) - points.row(v);
      up += a.cross(b);
    }
    is_proper[v] = IsProperStar(rings, points, v, up);
  }
  return is_proper;
}

}  // namespace musclewarp
