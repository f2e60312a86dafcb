// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// The inside of a closed mesh in cubes: those whose centres are inside.
struct VoxelGrid {
  using Cell = std::array<int, 3>;

  Eigen::RowVector3d origin;  // corner of cell (0, 0, 0), mm
  double size = 0;            // edge of a cube, mm
  Cell counts = {};
  std::vector<int> index_of;  // by cell, x fastest: index of the voxel, or -1
  std::vector<Cell> cells;    // by voxel

  int num_voxels() const { return static_cast<int>(cells.size()); }
  Eigen::RowVector3d Center(int voxel) const;
  // Index of the voxel of a cell, -1 if it is none or beyond the grid.
  int At(const Cell& cell) const;
  Cell CellOf(const Eigen::RowVector3d& point) const;
  // The voxel next to a point, of those at most two cells away; -1 if there is
  // none.
  int Nearest(const Eigen::RowVector3d& point) const;
};

// About `wanted` voxels, more where the mesh is thin: at least three across its
// mean thickness, but not eight times as many. Only the largest piece that
// hangs together over faces is kept; none where the mesh is thinner than all
// that. Precondition (CHECKed): the mesh holds a volume.
VoxelGrid Voxelize(const TriangleSoup& mesh, int wanted);

// The way through the voxels from the nearest of `sources` to each voxel, mm.
Eigen::VectorXd DistancesWithin(const VoxelGrid& grid,
                                const std::vector<int>& sources);

}  // namespace musclewarp
