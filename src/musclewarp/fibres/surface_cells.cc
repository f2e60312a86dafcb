// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/fibres/surface_cells.h"

#include "musclewarp/cgal/triangle_meets_box.h"
#include "musclewarp/mesh/triangle.h"

namespace musclewarp {
namespace {

bool MeetsCell(const Corners& triangle,
               const VoxelGrid& grid,
               const VoxelGrid::Cell& cell) {
  const Eigen::RowVector3d lower =
      grid.origin + grid.size * Eigen::RowVector3d(cell[0], cell[1], cell[2]);
  return TriangleMeetsBox(triangle, lower, lower.array() + grid.size);
}

}  // namespace

std::vector<char> SurfaceCells(const TriangleSoup& mesh,
                               const VoxelGrid& grid) {
  std::vector<char> is_surface(grid.index_of.size(), 0);
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    const Corners corners = CornersOf(mesh.points, mesh.triangles.row(f));
    const VoxelGrid::Cell low = grid.CellOf(corners.colwise().minCoeff());
    const VoxelGrid::Cell high = grid.CellOf(corners.colwise().maxCoeff());
    for (int z = low[2]; z <= high[2]; ++z) {
      for (int y = low[1]; y <= high[1]; ++y) {
        for (int x = low[0]; x <= high[0]; ++x) {
          const VoxelGrid::Cell cell = {x, y, z};
          char& here = is_surface[grid.NumberOf(cell)];
          if (here) continue;
          here = low == high || MeetsCell(corners, grid, cell);
        }
      }
    }
  }
  return is_surface;
}

}  // namespace musclewarp
