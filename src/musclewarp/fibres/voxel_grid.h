// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// The interior of a closed mesh as a set of cubes, the voxels, in a regular
// grid of cells. A cell is a voxel if its centre is inside the mesh. Where the
// mesh is too thin for that, as tendons are, the cells that its surface passes
// through are voxels. Distances and flows through a muscle are computed on this
// grid.
struct VoxelGrid {
  // The position of a cell in the grid along x, y and z, counted from 0.
  using Cell = std::array<int, 3>;

  Eigen::RowVector3d origin;  // lowest corner of cell (0, 0, 0), mm
  double size = 0;            // length of the edges of a cube, mm
  Cell counts = {};           // number of cells along x, y and z

  // The voxel index of every cell, -1 for cells that are not voxels. x changes
  // fastest, then y.
  std::vector<int> index_of;

  // The cell of every voxel.
  std::vector<Cell> cells;

  int num_voxels() const { return static_cast<int>(cells.size()); }

  // Returns the centre of a voxel, mm.
  Eigen::RowVector3d Center(int voxel) const;

  // Returns the number of a cell: its index into `index_of`.
  int NumberOf(const Cell& cell) const {
    return (cell[2] * counts[1] + cell[1]) * counts[0] + cell[0];
  }

  // Returns the index of the voxel of a cell, or -1 if the cell is not a voxel
  // or is beyond the grid.
  int At(const Cell& cell) const;

  // Returns the cell that contains a point (mm); it may be outside the grid.
  Cell CellOf(const Eigen::RowVector3d& point) const;

  // Returns the voxels that are at most `reach` cells away along each axis,
  // without `voxel` itself.
  std::vector<int> Around(int voxel, int reach) const;

  // Returns the voxel nearest to a point (mm) among those at most two cells
  // away, or -1 if there is none.
  int Nearest(const Eigen::RowVector3d& point) const;
};

// Fills a closed mesh (mm) with about `wanted` voxels. A thin mesh gets more,
// so that at least three fit across its mean thickness, but at most eight times
// as many. The result consists of the largest set of voxels that is connected
// over faces, and of voxels that are connected to it through parts of the mesh
// thinner than a voxel. It is empty if the mesh is too thin everywhere.
// Precondition (CHECKed): the mesh has a positive volume.
VoxelGrid Voxelize(const TriangleSoup& mesh, int wanted);

// Returns the centres of all voxels, #C x 3, mm.
Points Centers(const VoxelGrid& grid);

// Returns, for every voxel, the length (mm) of the shortest path through the
// voxels from the nearest of `sources`; infinity if there is none. It is
// approximate: steps to the 26 neighbours have lengths that are multiples of a
// third of an edge.
Eigen::VectorXd DistancesWithin(const VoxelGrid& grid,
                                const std::vector<int>& sources);

}  // namespace musclewarp
