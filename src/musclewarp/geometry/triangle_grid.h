// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "musclewarp/geometry/triangle_bvh.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// What a ray tells of where it starts.
enum class RayParity {
  kEven,
  kOdd,
  kOnSurface,  // it starts on a triangle
  kUndecided,  // it passes an edge or a corner: ask along another direction
};

// The triangles of a mesh in a uniform 3D grid, for rays: only those in the
// cells that a ray passes are tested (Kellnhofer and Kohout, section 3.2).
// Takes any soup; memory and time to build go with the number of triangles.
// Queries are const and may run on many threads.
class TriangleGrid {
 public:
  TriangleGrid(const Points& points, const Triangles& triangles);

  // False: the point is surely outside of everything.
  bool BoxContains(const Eigen::RowVector3d& point) const {
    return !corners_.empty() && box_.Contains(point);
  }

  // The cell of a point that BoxContains, if no triangle touches it: all its
  // points are then on the same side of everything. Else -1.
  int EmptyCell(const Eigen::RowVector3d& point) const {
    const int cell = Index(CellOf(point));
    return starts_[cell] == starts_[cell + 1] ? cell : -1;
  }
  int num_cells() const { return counts_[0] * counts_[1] * counts_[2]; }

  // The box around everything.
  const Box3& box() const { return box_; }

  // How often the ray from `point`, which BoxContains (CHECKed), crosses
  // triangles. By exact predicates: a ray that crosses an edge or a corner is
  // never miscounted, but reported. `direction` has any length above 0.
  RayParity CountCrossings(const Eigen::RowVector3d& point,
                           const Eigen::RowVector3d& direction) const;

  // The distance, mm, from a point along a unit direction to the first
  // triangle; infinite if there is none. No ray slips through between two
  // triangles with a common edge.
  double FirstHit(const Eigen::RowVector3d& point,
                  const Eigen::RowVector3d& direction) const;

 private:
  std::array<int, 3> CellOf(const Eigen::RowVector3d& point) const;
  int Index(const std::array<int, 3>& cell) const {
    return (cell[2] * counts_[1] + cell[1]) * counts_[0] + cell[0];
  }

  // Calls visit(cell, where the ray leaves it) for the cells on the segment
  // from `start` to `end` in order, until it returns false. The second argument
  // is in units of the segment.
  template <typename Visit>
  void ForEachCell(const Eigen::RowVector3d& start,
                   const Eigen::RowVector3d& end,
                   const Visit& visit) const;

  std::vector<Corners> corners_;  // by triangle
  Box3 box_ = {};
  double cell_ = 1;                 // edge of a cell, mm
  std::array<int, 3> counts_ = {};  // of cells along x, y and z
  // The triangles of cell c are items_[starts_[c]] to items_[starts_[c + 1]].
  std::vector<int> starts_;
  std::vector<int> items_;
};

}  // namespace musclewarp
