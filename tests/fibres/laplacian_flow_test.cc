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

// Between the ends, that is: at them the flow comes in through walls, too.
TEST(LaplacianFlow, IsLinearInABar) {
  const Bar bar;
  double low_sum = 0, high_sum = 0;
  int low_count = 0, high_count = 0;
  for (int v = 0; v < bar.grid.num_voxels(); ++v) {
    const double z = bar.grid.Center(v)[2];
    const double u = bar.flow.potential[v];
    if (std::abs(z + 15) < bar.grid.size / 2) low_sum += u, ++low_count;
    if (std::abs(z - 15) < bar.grid.size / 2) high_sum += u, ++high_count;
  }
  const double low = low_sum / low_count, high = high_sum / high_count;
  for (int v = 0; v < bar.grid.num_voxels(); ++v) {
    const double z = bar.grid.Center(v)[2];
    if (std::abs(z) > 15) continue;
    EXPECT_NEAR(bar.flow.potential[v],
                (low + high) / 2 + z / 30 * (high - low),
                (high - low) * bar.grid.size / 30);
  }
  EXPECT_EQ(bar.flow.potential.minCoeff(), 0);
  EXPECT_NEAR(bar.flow.potential.maxCoeff(), 1, 1e-15);
}

TEST(LaplacianFlow, StreamLinesOfABarAreStraight) {
  const Bar bar;
  const Eigen::RowVector3d start(2.1, -3.3, 5);
  const Points line = StreamLine(bar.flow, start);
  ASSERT_GT(line.rows(), 10);
  for (Eigen::Index i = 1; i < line.rows(); ++i) {
    EXPECT_GE(line(i, 2), line(i - 1, 2));
    if (std::abs(line(i, 2)) > 15) continue;  // near the ends
    // The residual of the solver bends lines by a part of a voxel.
    EXPECT_NEAR(line(i, 0), start[0], 0.05 * bar.grid.size);
    EXPECT_NEAR(line(i, 1), start[1], 0.05 * bar.grid.size);
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
    const Points line = StreamLine(flow, grid.Center(v));
    EXPECT_LT(line(0, 2), -40);
    EXPECT_GT(line(line.rows() - 1, 2), 40);
  }
}

// Stream lines from all over a section reach all of an end, which is a strip
// along the bar here: with potentials held at the ends they would meet at its
// near edge.
TEST(LaplacianFlow, SpreadsOverAnEndThatRunsAlongTheMuscle) {
  const VoxelGrid grid = Voxelize(Box(10, 10, 60), 3000);
  std::vector<int> strip;
  for (const int v : Beyond(grid, 0, true)) {
    if (grid.Center(v)[0] > 5 - 2 * grid.size) strip.push_back(v);
  }
  ASSERT_GT(strip.size(), 20u);
  const LaplacianFlow flow = SolveFlow(grid, Beyond(grid, -27, false), strip);
  const Points seeds = SpreadOverSection(flow, 25);
  Eigen::VectorXd ends(seeds.rows());
  for (Eigen::Index i = 0; i < seeds.rows(); ++i) {
    const Points line = StreamLine(flow, seeds.row(i));
    ends[i] = line(line.rows() - 1, 2);
  }
  EXPECT_LT(ends.minCoeff(), 6);
  EXPECT_GT(ends.maxCoeff(), 24);
  EXPECT_NEAR(ends.mean(), 15, 3);
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
