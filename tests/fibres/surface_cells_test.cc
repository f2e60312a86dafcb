// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/fibres/surface_cells.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fibres/tendon_muscle.h"
#include "musclewarp/proximity/triangle_bvh.h"

namespace musclewarp {
namespace {

TEST(SurfaceCells, AreThoseThatTheSurfacePassesThrough) {
  const TriangleSoup muscle = MuscleWithTendon();
  const VoxelGrid grid = Voxelize(muscle, 2000);
  const std::vector<char> is_surface = SurfaceCells(muscle, grid);
  ASSERT_EQ(is_surface.size(), grid.index_of.size());
  for (Eigen::Index i = 0; i < muscle.points.rows(); ++i) {
    EXPECT_TRUE(is_surface[grid.NumberOf(grid.CellOf(muscle.points.row(i)))]);
  }
  // No point of the surface is nearer to the centre of another cell than half
  // its edge, and one is within half its diagonal of that of such a cell.
  const TriangleBvh surface(muscle.points, muscle.triangles);
  const double half_diagonal = std::sqrt(3.0) / 2 * grid.size;
  for (int z = 0; z < grid.counts[2]; ++z) {
    for (int y = 0; y < grid.counts[1]; ++y) {
      for (int x = 0; x < grid.counts[0]; ++x) {
        const Eigen::RowVector3d center =
            grid.origin +
            grid.size * Eigen::RowVector3d(x + 0.5, y + 0.5, z + 0.5);
        const double distance = surface.ClosestPoint(center).distance;
        if (is_surface[grid.NumberOf({x, y, z})]) {
          EXPECT_LE(distance, half_diagonal * (1 + 1e-12));
        } else {
          EXPECT_GE(distance, grid.size / 2 * (1 - 1e-12));
        }
      }
    }
  }
}

}  // namespace
}  // namespace musclewarp
