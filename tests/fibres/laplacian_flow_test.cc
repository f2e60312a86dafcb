// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/fibres/laplacian_flow.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/meshes.h"

namespace musclewarp {
namespace {

// Voxels of a grid below and above two heights.
std::vector<int> Beyond(const VoxelGrid& grid, double z, bool above) {
  std::vector<int> voxels;
  for (int v = 0; v < grid.num_voxels(); ++v) {
    if ((grid.Center(v)[2] > z) == above) voxels.push_back(v);
  }
  return voxels;
}

struct Bar {
  VoxelGrid grid = Voxelize(Box(10, 10, 60), 3000);
  LaplacianFlow flow =
      SolveFlow(grid, Beyond(grid, -27, false), Beyond(grid, 27, true));
};

// The relative residual of the linear solver, for potentials up to 1.
constexpr double kSolved = 1e-4;

TEST(LaplacianFlow, IsLinearInABar) {
  const Bar bar;
  double lowest = -30, highest = 30;  // next to the free voxels
  for (int v = 0; v < bar.grid.num_voxels(); ++v) {
    const double z = bar.grid.Center(v)[2];
    if (bar.flow.potential[v] == 0) lowest = std::max(lowest, z);
    if (bar.flow.potential[v] == 1) highest = std::min(highest, z);
  }
  for (int v = 0; v < bar.grid.num_voxels(); ++v) {
    const double z = bar.grid.Center(v)[2];
    const double expected =
        std::min(1.0, std::max(0.0, (z - lowest) / (highest - lowest)));
    EXPECT_NEAR(bar.flow.potential[v], expected, kSolved);
  }
}

TEST(LaplacianFlow, StreamLinesOfABarAreStraight) {
  const Bar bar;
  const Eigen::RowVector3d start(2.1, -3.3, 5);
  const Points line = StreamLine(bar.flow, start);
  ASSERT_GT(line.rows(), 10);
  for (Eigen::Index i = 1; i + 1 < line.rows(); ++i) {
    // The residual of the solver bends lines by a part of a voxel.
    EXPECT_NEAR(line(i, 0), start[0], 0.01 * bar.grid.size);
    EXPECT_NEAR(line(i, 1), start[1], 0.01 * bar.grid.size);
    EXPECT_GE(line(i, 2), line(i - 1, 2));
  }
  EXPECT_LT(line(0, 2), -26);
  EXPECT_GT(line(line.rows() - 1, 2), 26);
}

// From anywhere in a bent body: no line leaves the voxels or stops on the way.
TEST(LaplacianFlow, EveryStreamLineRunsFromOriginToInsertion) {
  TriangleSoup bent = Spindle(9, 50, 3);
  for (Eigen::Index i = 0; i < bent.points.rows(); ++i) {
    bent.points(i, 0) += 0.01 * bent.points(i, 2) * bent.points(i, 2);
  }
  const VoxelGrid grid = Voxelize(bent, 2000);
  const LaplacianFlow flow =
      SolveFlow(grid, Beyond(grid, -42, false), Beyond(grid, 42, true));
  for (int v = 0; v < grid.num_voxels(); v += 7) {
    // The ends themselves have no flow.
    if (flow.potential[v] == 0 || flow.potential[v] == 1) continue;
    const Points line = StreamLine(flow, grid.Center(v));
    const int first = grid.At(grid.CellOf(line.row(0)));
    const int last = grid.At(grid.CellOf(line.row(line.rows() - 1)));
    ASSERT_GE(first, 0);
    ASSERT_GE(last, 0);
    EXPECT_EQ(flow.potential[first], 0);
    EXPECT_EQ(flow.potential[last], 1);
  }
}

TEST(LaplacianFlow, SeedsSpreadEvenlyOverTheSection) {
  const Bar bar;
  const Points seeds = SpreadOverSection(bar.flow, 25);
  ASSERT_EQ(seeds.rows(), 25);
  // 25 on 10 x 10 mm: 2 mm apart if they stood in rows, and on either side of
  // the middle.
  for (Eigen::Index i = 0; i < seeds.rows(); ++i) {
    for (Eigen::Index k = 0; k < i; ++k) {
      EXPECT_GT((seeds.row(i) - seeds.row(k)).head<2>().norm(), 0.8);
    }
  }
  EXPECT_LT(seeds.colwise().mean().head<2>().norm(), 0.3);
  EXPECT_EQ(SpreadOverSection(bar.flow, 1).rows(), 1);
  EXPECT_LT(SpreadOverSection(bar.flow, 1).row(0).head<2>().norm(),
            bar.grid.size);
}

}  // namespace
}  // namespace musclewarp
