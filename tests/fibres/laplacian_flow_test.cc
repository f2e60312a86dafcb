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

// What flows into a voxel flows out of it, but for the residual of the solver.
void ExpectNothingIsLost(const LaplacianFlow& flow) {
  const VoxelGrid& grid = *flow.grid;
  const double most = flow.outflow.cwiseAbs().maxCoeff();
  double through = 0;
  for (int v = 0; v < grid.num_voxels(); ++v) {
    double out = 0;
    for (int k = 0; k < 3; ++k) {
      for (const int step : {-1, 1}) {
        VoxelGrid::Cell beside = grid.cells[v];
        beside[k] += step;
        const int next = grid.At(beside);
        out += next < 0 ? flow.outflow[v]
                        : flow.potential[next] - flow.potential[v];
        if (next < 0) through += std::max(0.0, flow.outflow[v]);
      }
    }
    EXPECT_NEAR(out, 0, 1e-3 * most) << v;
  }
  EXPECT_GT(through, 0);
}

TEST(LaplacianFlow, NothingIsLostOnTheWay) {
  const Bar bar;
  ExpectNothingIsLost(bar.flow);
  const VoxelGrid grid = Voxelize(Spindle(9, 30, 3), 1500);
  ExpectNothingIsLost(
      SolveFlow(grid, Beyond(grid, -20, false), Beyond(grid, 10, true)));
}

// Through all of the surface of an end alike, and none elsewhere.
TEST(LaplacianFlow, EntersAndLeavesEvenly) {
  const Bar bar;
  const double in = bar.flow.outflow.minCoeff();
  const double out = bar.flow.outflow.maxCoeff();
  EXPECT_LT(in, 0);
  for (int v = 0; v < bar.grid.num_voxels(); ++v) {
    const double z = bar.grid.Center(v)[2];
    EXPECT_EQ(bar.flow.outflow[v], z < -27 ? in : z > 27 ? out : 0);
  }
}

// An end inside the muscle is extended until it reaches the surface.
TEST(LaplacianFlow, EntersThroughTheSurfaceNextToAnEndInside) {
  const VoxelGrid grid = Voxelize(Box(10, 10, 60), 3000);
  const int inside = grid.Nearest(Eigen::RowVector3d(0, 0, -20));
  const LaplacianFlow flow = SolveFlow(grid, {inside}, Beyond(grid, 27, true));
  ExpectNothingIsLost(flow);
  for (int v = 0; v < grid.num_voxels(); ++v) {
    if (flow.outflow[v] >= 0) continue;
    // A layer after layer, each by one voxel more, until 5 mm are reached.
    EXPECT_LT((grid.Center(v) - grid.Center(inside)).cwiseAbs().maxCoeff(),
              5 + 4 * grid.size);
  }
}

// The flow (x, -y), whose potential (x^2 - y^2) / 2 on a square of voxels from
// (1, 1) to (6, 6) has velocities that are linear in each of them: stream lines
// are exact, on which x y is the same everywhere.
TEST(StreamLine, IsExactIfVelocitiesAreLinear) {
  constexpr int kCells = 5;
  VoxelGrid grid;
  grid.origin << 1, 1, 0;
  grid.size = 1;
  grid.counts = {kCells, kCells, 1};
  LaplacianFlow flow;
  flow.grid = &grid;
  flow.potential.resize(kCells * kCells);
  flow.outflow.setZero(kCells * kCells);
  for (int j = 0; j < kCells; ++j) {
    for (int i = 0; i < kCells; ++i) {
      const int v = grid.num_voxels();
      grid.index_of.push_back(v);
      grid.cells.push_back({i, j, 0});
      const double x = 1.5 + i, y = 1.5 + j;
      flow.potential[v] = (x * x - y * y) / 2;
      // In from the left (1) and from above (6), out to the right (6) and below
      // (1); corners, which have one of both, are not passed.
      if (i == 0) flow.outflow[v] = -1;
      if (j == kCells - 1) flow.outflow[v] = -6;
      if (j == 0) flow.outflow[v] = 1;
      if (i == kCells - 1) flow.outflow[v] = 6;
    }
  }
  for (const auto& [x, y] : {std::pair(4.25, 4.75), {3.5, 3.6}, {2.6, 5.2}}) {
    const Points line = StreamLine(flow, {x, y, 0.5});
    ASSERT_GT(line.rows(), 4);
    for (const auto& p : line.rowwise()) {
      EXPECT_NEAR(p[0] * p[1], x * y, 1e-9);
      EXPECT_EQ(p[2], 0.5);
      const bool is_start = p[0] == x && p[1] == y;
      EXPECT_TRUE(is_start || std::abs(p[0] - std::round(p[0])) < 1e-12 ||
                  std::abs(p[1] - std::round(p[1])) < 1e-12);
    }
    // From above to the right; each face between once.
    EXPECT_EQ(line(0, 1), 6);
    EXPECT_EQ(line(line.rows() - 1, 0), 6);
    for (Eigen::Index i = 1; i < line.rows(); ++i) {
      EXPECT_GT(line(i, 0), line(i - 1, 0));
      EXPECT_LT(line(i, 1), line(i - 1, 1));
    }
  }
}

// The widest section of a spindle is its middle.
TEST(SpreadOverSection, IsTheWidestSection) {
  const VoxelGrid grid = Voxelize(MovedBy(Spindle(10, 40, 3), {0, 0, 5}), 3000);
  const LaplacianFlow flow =
      SolveFlow(grid, Beyond(grid, -28, false), Beyond(grid, 38, true));
  const Points seeds = SpreadOverSection(flow, 20);
  ASSERT_EQ(seeds.rows(), 20);
  // Within 18 mm of the middle a section has four fifths of its area.
  EXPECT_NEAR(seeds.col(2).mean(), 5, 18);
  // A section of constant potential is a plane but for the voxels.
  EXPECT_LT(seeds.col(2).maxCoeff() - seeds.col(2).minCoeff(), 3 * grid.size);
  // The mean square distance from the axis of a disc of 10 mm is half of 100;
  // of four fifths of it 40.
  EXPECT_NEAR(seeds.leftCols<2>().rowwise().squaredNorm().mean(), 45, 9);
}

// Two thirds of the flow have left where the bar is twice as thick.
TEST(SpreadOverSection, IsOneThroughWhichNearlyAllFlows) {
  TriangleSoup flask = LatticeBox(10, 10, 40);
  for (auto p : flask.points.rowwise()) {
    if (p[2] > 20) p[0] = 2 * p[0] - 5;
  }
  const VoxelGrid grid = Voxelize(flask, 3000);
  std::vector<int> insertion;
  for (const int v : Beyond(grid, 22, true)) insertion.push_back(v);
  const LaplacianFlow flow = SolveFlow(grid, Beyond(grid, 2, false), insertion);
  EXPECT_LT(SpreadOverSection(flow, 10).col(2).maxCoeff(), 25);
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
  EXPECT_EQ(SpreadOverSection(bar.flow, 0).rows(), 0);
  EXPECT_EQ(SpreadOverSection(bar.flow, 1).rows(), 1);
  EXPECT_LT(SpreadOverSection(bar.flow, 1).row(0).head<2>().norm(),
            bar.grid.size);
}

}  // namespace
}  // namespace musclewarp
