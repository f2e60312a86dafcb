// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/fibres/surface_cells.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>

#include "musclewarp/mesh/triangle.h"

namespace musclewarp {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;

CGAL::Bbox_3 BoxOf(const VoxelGrid& grid, const VoxelGrid::Cell& cell) {
  const Eigen::RowVector3d lower =
      grid.origin + grid.size * Eigen::RowVector3d(cell[0], cell[1], cell[2]);
  const Eigen::RowVector3d upper = lower.array() + grid.size;
  return {lower[0], lower[1], lower[2], upper[0], upper[1], upper[2]};
}

}  // namespace

std::vector<char> SurfaceCells(const TriangleSoup& mesh,
                               const VoxelGrid& grid) {
  std::vector<char> is_surface(grid.index_of.size(), 0);
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    const Corners corners = CornersOf(mesh.points, mesh.triangles.row(f));
    Kernel::Point_3 p[3];
    for (int c = 0; c < 3; ++c) {
      p[c] = {corners(c, 0), corners(c, 1), corners(c, 2)};
    }
    const Kernel::Triangle_3 triangle(p[0], p[1], p[2]);
    const VoxelGrid::Cell low = grid.CellOf(corners.colwise().minCoeff());
    const VoxelGrid::Cell high = grid.CellOf(corners.colwise().maxCoeff());
    for (int z = low[2]; z <= high[2]; ++z) {
      for (int y = low[1]; y <= high[1]; ++y) {
        for (int x = low[0]; x <= high[0]; ++x) {
          const VoxelGrid::Cell cell = {x, y, z};
          char& here = is_surface[grid.NumberOf(cell)];
          if (here) continue;
          here = low == high || CGAL::do_intersect(triangle, BoxOf(grid, cell));
        }
      }
    }
  }
  return is_surface;
}

}  // namespace musclewarp
