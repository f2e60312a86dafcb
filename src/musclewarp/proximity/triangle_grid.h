// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/proximity/triangle_bvh.h"

namespace musclewarp {

// The parity of the number of triangles that a ray crosses. It tells whether
// the start of the ray is inside a closed mesh (kOdd) or outside (kEven).
enum class RayParity {
  kEven,
  kOdd,
  kOnSurface,  // the ray starts on a triangle
  kUndecided,  // the ray meets an edge or a corner; try another direction
};

// A uniform grid over the triangles of a mesh, which answers queries about
// rays: only triangles in the cells that a ray passes are tested (Kellnhofer
// and Kohout, section 3.2). Any triangle soup is allowed. Memory and the time
// to build the grid are proportional to the number of triangles. Queries are
// const and may run on many threads.
class TriangleGrid {
 public:
  // Sorts the triangles (#V x 3, #F x 3) into cells about as large as they are.
  TriangleGrid(const Points& points, const Triangles& triangles);

  // Returns true if `point` is in the box around all triangles. A point for
  // which this is false is outside the mesh.
  bool BoxContains(const Eigen::RowVector3d& point) const {
    return !corners_.empty() && box_.Contains(point);
  }

  // Returns the index of the cell that contains `point` if no triangle touches
  // the cell, else -1. All points of such a cell are on the same side of the
  // mesh. Precondition: BoxContains(point).
  int EmptyCell(const Eigen::RowVector3d& point) const {
    const int cell = Index(CellOf(point));
    return starts_[cell] == starts_[cell + 1] ? cell : -1;
  }

  // The number of all cells, empty or not.
  int num_cells() const { return counts_[0] * counts_[1] * counts_[2]; }

  // The box around all triangles, slightly enlarged.
  const Box3& box() const { return box_; }

  // Returns the parity of the number of triangles that the ray from `point`
  // along `direction` crosses. The crossings are found by exact predicates: a
  // ray that meets an edge or a corner is reported as kUndecided and never
  // miscounted. `direction` may have any length above 0. Precondition
  // (CHECKed): BoxContains(point).
  RayParity CountCrossings(const Eigen::RowVector3d& point,
                           const Eigen::RowVector3d& direction) const;

  // Returns the distance (mm) from `point` along a direction of unit length to
  // the first triangle, or infinity if there is none. No ray passes between two
  // triangles with a common edge.
  double FirstHit(const Eigen::RowVector3d& point,
                  const Eigen::RowVector3d& direction) const;

 private:
  // Enters every triangle into all cells that its box, enlarged by `margin`
  // (mm), touches.
  void SortIntoCells(double margin);

  std::array<int, 3> CellOf(const Eigen::RowVector3d& point) const;
  int Index(const std::array<int, 3>& cell) const {
    return (cell[2] * counts_[1] + cell[1]) * counts_[0] + cell[0];
  }

  // Calls visit(cell, t) for the cells on the segment from `start` to `end` in
  // order, until it returns false. The segment leaves the cell at
  // start + t (end - start).
  template <typename Visit>
  void ForEachCell(const Eigen::RowVector3d& start,
                   const Eigen::RowVector3d& end,
                   const Visit& visit) const;

  std::vector<Corners> corners_;  // of each triangle
  Box3 box_ = {};
  double cell_ = 1;                 // edge of a cell, mm
  std::array<int, 3> counts_ = {};  // of cells along x, y and z
  // The triangles of cell c are items_[starts_[c]] to items_[starts_[c + 1]].
  std::vector<int> starts_;
  std::vector<int> items_;
};

}  // namespace musclewarp
