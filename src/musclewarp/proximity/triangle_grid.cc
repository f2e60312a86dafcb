// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/proximity/triangle_grid.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "musclewarp/cgal/exact_predicates.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// The largest number of cells for each triangle. A surface fills few of them.
constexpr double kCellsPerTriangle = 4;

// The boxes of triangles are enlarged by this, relative to the size of their
// coordinates. A ray that rounding puts into the next cell still meets them.
constexpr double kMargin = 1e-9;

enum class Crossing { kNone, kThrough, kEdge, kStart };

// Tells how the segment from p to q meets a triangle that is far from q.
Crossing CrossingOf(const RowVector3d& p,
                    const RowVector3d& q,
                    const Corners& triangle) {
  const RowVector3d a = triangle.row(0);
  const RowVector3d b = triangle.row(1);
  const RowVector3d c = triangle.row(2);
  const int side_of_p = Orientation(a, b, c, p);
  const int side_of_q = Orientation(a, b, c, q);
  if (side_of_p * side_of_q > 0) return Crossing::kNone;
  const int ab = Orientation(p, q, a, b);
  const int bc = Orientation(p, q, b, c);
  if (ab * bc < 0) return Crossing::kNone;
  const int ca = Orientation(p, q, c, a);
  if (ab * ca < 0 || bc * ca < 0) return Crossing::kNone;
  // The line meets the triangle, and it meets its plane in p only.
  if (side_of_p == 0 && side_of_q != 0) return Crossing::kStart;
  return ab == 0 || bc == 0 || ca == 0 ? Crossing::kEdge : Crossing::kThrough;
}

// Returns where on a segment, as a share of it, the plane of a triangle lies
// that the segment meets.
double PlaceOn(const RowVector3d& p,
               const RowVector3d& q,
               const Corners& triangle) {
  const RowVector3d a = triangle.row(0);
  const RowVector3d normal = (triangle.row(1) - a).cross(triangle.row(2) - a);
  const double before = normal.dot(a - p);
  const double along = normal.dot(q - p);
  if (along != 0) return std::clamp(before / along, 0.0, 1.0);
  // The segment is in the plane; take the nearest corner.
  const RowVector3d way = q - p;
  double nearest = 1;
  for (int k = 0; k < 3; ++k) {
    nearest =
        std::min(nearest, (triangle.row(k) - p).dot(way) / way.squaredNorm());
  }
  return std::max(0.0, nearest);
}

}  // namespace

TriangleGrid::TriangleGrid(const Points& points, const Triangles& triangles) {
  const Eigen::Index count = triangles.rows();
  if (count == 0) return;
  corners_.resize(count);
  double extents = 0;
  double largest = 0;
  for (int k = 0; k < 3; ++k) {
    box_.lower[k] = std::numeric_limits<double>::infinity();
    box_.upper[k] = -box_.lower[k];
  }
  for (Eigen::Index f = 0; f < count; ++f) {
    for (int c = 0; c < 3; ++c) {
      corners_[f].row(c) = points.row(triangles(f, c));
    }
    const Box3 box = BoxOf(corners_[f], 0);
    double extent = 0;
    for (int k = 0; k < 3; ++k) {
      box_.lower[k] = std::min(box_.lower[k], box.lower[k]);
      box_.upper[k] = std::max(box_.upper[k], box.upper[k]);
      extent = std::max(extent, box.upper[k] - box.lower[k]);
      largest =
          std::max({largest, std::abs(box.lower[k]), std::abs(box.upper[k])});
    }
    extents += extent;
  }
  const double margin = kMargin * largest + std::numeric_limits<double>::min();
  double volume = 1;
  double longest = 0;
  for (int k = 0; k < 3; ++k) {
    box_.lower[k] -= margin;
    box_.upper[k] += margin;
    const double size = box_.upper[k] - box_.lower[k];
    volume *= size;
    longest = std::max(longest, size);
  }
  // Cells are as wide as triangles are on average, or wider if there would be
  // too many of them, in all or, in a box of little volume, along one side.
  cell_ = std::max({extents / static_cast<double>(count),
                    std::cbrt(volume / (kCellsPerTriangle * count)),
                    longest / (16 + std::sqrt(kCellsPerTriangle * count))});
  for (int k = 0; k < 3; ++k) {
    counts_[k] = 1 + static_cast<int>((box_.upper[k] - box_.lower[k]) / cell_);
  }
  SortIntoCells(margin);
}

void TriangleGrid::SortIntoCells(double margin) {
  // The pairs (cell, triangle) are sorted by counting.
  const Eigen::Index count = static_cast<Eigen::Index>(corners_.size());
  const auto for_each_cell = [&](Eigen::Index f, const auto& visit) {
    const Box3 box = BoxOf(corners_[f], margin);
    const auto low = CellOf({box.lower[0], box.lower[1], box.lower[2]});
    const auto high = CellOf({box.upper[0], box.upper[1], box.upper[2]});
    for (int z = low[2]; z <= high[2]; ++z) {
      for (int y = low[1]; y <= high[1]; ++y) {
        for (int x = low[0]; x <= high[0]; ++x) visit(Index({x, y, z}));
      }
    }
  };
  starts_.assign(1 + static_cast<size_t>(counts_[0]) * counts_[1] * counts_[2],
                 0);
  for (Eigen::Index f = 0; f < count; ++f) {
    for_each_cell(f, [&](int cell) { ++starts_[cell + 1]; });
  }
  for (size_t c = 1; c < starts_.size(); ++c) starts_[c] += starts_[c - 1];
  items_.resize(starts_.back());
  std::vector<int> next(starts_.begin(), starts_.end() - 1);
  for (Eigen::Index f = 0; f < count; ++f) {
    for_each_cell(
        f, [&](int cell) { items_[next[cell]++] = static_cast<int>(f); });
  }
}

RayParity TriangleGrid::CountCrossings(const RowVector3d& point,
                                       const RowVector3d& direction) const {
  CHECK(BoxContains(point));
  const Eigen::Map<const RowVector3d> lower(box_.lower.data());
  const Eigen::Map<const RowVector3d> upper(box_.upper.data());
  const RowVector3d end =
      point + 2 * (upper - lower).norm() / direction.norm() * direction;
  RayParity parity = RayParity::kEven;
  std::vector<int> crossed;  // a triangle may be in several cells
  ForEachCell(point, end, [&](int cell, double) {
    for (int i = starts_[cell]; i < starts_[cell + 1]; ++i) {
      switch (CrossingOf(point, end, corners_[items_[i]])) {
        case Crossing::kNone:
          break;
        case Crossing::kThrough:
          crossed.push_back(items_[i]);
          break;
        case Crossing::kEdge:
          parity = RayParity::kUndecided;
          break;
        case Crossing::kStart:
          parity = RayParity::kOnSurface;
          return false;
      }
    }
    return true;
  });
  if (parity != RayParity::kEven) return parity;
  std::sort(crossed.begin(), crossed.end());
  const auto last = std::unique(crossed.begin(), crossed.end());
  return (last - crossed.begin()) % 2 == 1 ? RayParity::kOdd : RayParity::kEven;
}

double TriangleGrid::FirstHit(const RowVector3d& point,
                              const RowVector3d& direction) const {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  if (corners_.empty()) return kNever;
  const Eigen::Map<const RowVector3d> lower(box_.lower.data());
  const Eigen::Map<const RowVector3d> upper(box_.upper.data());
  const double length =
      (0.5 * (lower + upper) - point).norm() + (upper - lower).norm();
  const RowVector3d end = point + length * direction;
  double nearest = kNever;  // in units of the segment
  ForEachCell(point, end, [&](int cell, double leaves) {
    for (int i = starts_[cell]; i < starts_[cell + 1]; ++i) {
      const Corners& triangle = corners_[items_[i]];
      if (CrossingOf(point, end, triangle) == Crossing::kNone) continue;
      nearest = std::min(nearest, PlaceOn(point, end, triangle));
    }
    return nearest > leaves;
  });
  return nearest * length;
}

std::array<int, 3> TriangleGrid::CellOf(const RowVector3d& point) const {
  std::array<int, 3> cell;
  for (int k = 0; k < 3; ++k) {
    cell[k] = static_cast<int>(std::clamp((point[k] - box_.lower[k]) / cell_,
                                          0.0,
                                          static_cast<double>(counts_[k] - 1)));
  }
  return cell;
}

// The algorithm is that of Amanatides and Woo, "A Fast Voxel Traversal
// Algorithm for Ray Tracing" (1987).
template <typename Visit>
void TriangleGrid::ForEachCell(const RowVector3d& start,
                               const RowVector3d& end,
                               const Visit& visit) const {
  const RowVector3d way = end - start;
  double enters = 0;
  double leaves = 1;
  for (int k = 0; k < 3; ++k) {
    if (way[k] == 0) {
      if (start[k] < box_.lower[k] || start[k] > box_.upper[k]) return;
      continue;
    }
    const double one = (box_.lower[k] - start[k]) / way[k];
    const double other = (box_.upper[k] - start[k]) / way[k];
    enters = std::max(enters, std::min(one, other));
    leaves = std::min(leaves, std::max(one, other));
  }
  if (enters > leaves) return;

  std::array<int, 3> cell = CellOf(start + enters * way);
  std::array<int, 3> step;
  std::array<double, 3> next;   // where the ray crosses into the next cell
  std::array<double, 3> width;  // of a cell
  for (int k = 0; k < 3; ++k) {
    step[k] = way[k] > 0 ? 1 : -1;
    if (way[k] == 0) {
      next[k] = std::numeric_limits<double>::infinity();
      width[k] = 0;
      continue;
    }
    const double wall =
        box_.lower[k] + cell_ * (way[k] > 0 ? cell[k] + 1 : cell[k]);
    next[k] = (wall - start[k]) / way[k];
    width[k] = cell_ / std::abs(way[k]);
  }
  while (true) {
    const int k = next[0] < next[1] ? (next[0] < next[2] ? 0 : 2)
                                    : (next[1] < next[2] ? 1 : 2);
    if (!visit(Index(cell), next[k])) return;
    cell[k] += step[k];
    if (cell[k] < 0 || cell[k] >= counts_[k]) return;
    next[k] += width[k];
  }
}

}  // namespace musclewarp
