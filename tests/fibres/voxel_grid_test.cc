// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/fibres/voxel_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>

#include <algorithm>
#include <cmath>

#include "fibres/tendon_muscle.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/proximity/inside_test.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

TEST(VoxelGrid, HoldsTheCellsWhoseCentresAreInside) {
  const TriangleSoup mesh = Spindle(10, 40, 3);
  const VoxelGrid grid = Voxelize(mesh, 2000);
  const InsideTest inside(mesh.points, mesh.triangles, 1);
  int expected = 0;
  for (int k = 0; k < grid.counts[2]; ++k) {
    for (int j = 0; j < grid.counts[1]; ++j) {
      for (int i = 0; i < grid.counts[0]; ++i) {
        const Eigen::RowVector3d center =
            grid.origin +
            grid.size * Eigen::RowVector3d(i + 0.5, j + 0.5, k + 0.5);
        const bool is_inside = inside.Contains(center);
        expected += is_inside;
        EXPECT_EQ(grid.At({i, j, k}) >= 0, is_inside);
      }
    }
  }
  EXPECT_EQ(grid.num_voxels(), expected);
  EXPECT_EQ(grid.At({-1, 0, 0}), -1);
}

TEST(VoxelGrid, HasAsManyVoxelsAsWantedAndMoreForSheets) {
  // A bulky body: the volume decides.
  EXPECT_NEAR(Voxelize(Icosphere(20, 3), 3000).num_voxels(), 3000, 100);
  // A sheet 2 mm thick (1.8 by volume over half its surface): three voxels
  // across, though fewer were wanted, up to eight times as many.
  EXPECT_NEAR(Voxelize(Box(40, 40, 2), 2000).size, 1.8 / 3, 0.01);
  EXPECT_NEAR(Voxelize(Box(40, 40, 2), 300).num_voxels(), 8 * 300, 400);
}

TEST(VoxelGrid, KeepsTheLargestPiece) {
  TriangleSoup two = Icosphere(10, 2);
  const TriangleSoup small = Icosphere(3, 2);
  const Eigen::Index offset = two.points.rows();
  two.points.conservativeResize(2 * offset, 3);
  two.points.bottomRows(offset) =
      small.points.rowwise() + Eigen::RowVector3d(20, 0, 0);
  const Eigen::Index faces = two.triangles.rows();
  two.triangles.conservativeResize(2 * faces, 3);
  two.triangles.bottomRows(faces) =
      small.triangles.array() + static_cast<int>(offset);
  const VoxelGrid grid = Voxelize(two, 2000);
  for (int v = 0; v < grid.num_voxels(); ++v) {
    EXPECT_LT(grid.Center(v).norm(), 10);
  }
}

TEST(VoxelGrid, FollowsATendonThinnerThanAVoxel) {
  const TriangleSoup muscle = MuscleWithTendon();
  const VoxelGrid grid = Voxelize(muscle, 2000);
  ASSERT_GT(grid.size, 1);  // the tendon is 0.6 mm thick
  const InsideTest inside(muscle.points, muscle.triangles, 1);
  double highest = 0;
  for (int v = 0; v < grid.num_voxels(); ++v) {
    const Eigen::RowVector3d center = grid.Center(v);
    highest = std::max(highest, center[2]);
    // The belly is as without a tendon.
    if (center[2] < 0) {
      EXPECT_TRUE(inside.Contains(center));
    }
  }
  EXPECT_GT(highest, 60 - 2 * grid.size);
  const int bottom = grid.Nearest(Eigen::RowVector3d(0, 0, -57));
  ASSERT_GE(bottom, 0);
  EXPECT_TRUE(DistancesWithin(grid, {bottom}).allFinite());
}

TEST(VoxelGrid, KnowsWhatIsAround) {
  const VoxelGrid grid = Voxelize(Box(10, 10, 10), 1000);
  const int middle = grid.Nearest(Eigen::RowVector3d(0, 0, 0));
  ASSERT_GE(middle, 0);
  EXPECT_EQ(grid.Around(middle, 1).size(), 26u);
  EXPECT_EQ(grid.Around(middle, 2).size(), 124u);
  for (const int voxel : grid.Around(middle, 1)) {
    EXPECT_LT((grid.Center(voxel) - grid.Center(middle)).norm(),
              1.8 * grid.size);
  }
}

TEST(VoxelGrid, DistancesGoThroughTheMesh) {
  const VoxelGrid grid = Voxelize(Box(10, 10, 60), 3000);
  const int start = grid.Nearest(Eigen::RowVector3d(0, 0, -29));
  ASSERT_GE(start, 0);
  const Eigen::VectorXd distances = DistancesWithin(grid, {start});
  EXPECT_EQ(distances[start], 0);
  for (int v = 0; v < grid.num_voxels(); ++v) {
    const double straight = (grid.Center(v) - grid.Center(start)).norm();
    // Steps of 3, 4 and 5 thirds miss the Euclidean distance by at most an
    // eighth, on the long side but for diagonals (4/3 for sqrt 2, 5/3 for
    // sqrt 3).
    constexpr double kLongest = 1.13;
    constexpr double kShortest = 0.94;
    constexpr double kRounding = 1e-9;  // mm
    EXPECT_LT(distances[v], kLongest * straight + kRounding);
    EXPECT_GT(distances[v], kShortest * straight - kRounding);
  }
}

// In a box the shortest way goes along diagonals first: of the differences
// along the axes the least along diagonals of cubes (5/3 of an edge), the next
// along those of squares (4/3), and the rest straight.
TEST(VoxelGrid, DistancesInABoxAreThoseOfDiagonalSteps) {
  const VoxelGrid grid = Voxelize(Box(10, 10, 20), 1000);
  const int start = grid.Nearest(Eigen::RowVector3d(-3, 2, -6));
  ASSERT_GE(start, 0);
  const Eigen::VectorXd distances = DistancesWithin(grid, {start});
  for (int v = 0; v < grid.num_voxels(); ++v) {
    std::array<int, 3> steps;
    for (int k = 0; k < 3; ++k) {
      steps[k] = std::abs(grid.cells[v][k] - grid.cells[start][k]);
    }
    std::sort(steps.begin(), steps.end());
    const int thirds =
        5 * steps[0] + 4 * (steps[1] - steps[0]) + 3 * (steps[2] - steps[1]);
    EXPECT_NEAR(distances[v], grid.size * thirds / 3, 1e-9);
  }
}

TEST(VoxelGrid, DistancesAreFromTheNearestSource) {
  const VoxelGrid grid = Voxelize(Box(10, 10, 20), 1000);
  const int low = grid.Nearest(Eigen::RowVector3d(0, 0, -9));
  const int high = grid.Nearest(Eigen::RowVector3d(0, 0, 9));
  const Eigen::VectorXd both = DistancesWithin(grid, {low, high});
  EXPECT_EQ(
      both,
      DistancesWithin(grid, {low}).cwiseMin(DistancesWithin(grid, {high})));
}

// Three voxels in a row, the middle one of which is none.
TEST(VoxelGrid, NothingIsReachedAcrossAGap) {
  VoxelGrid grid;
  grid.origin.setZero();
  grid.size = 2;
  grid.counts = {3, 1, 1};
  grid.index_of = {0, -1, 1};
  grid.cells = {{0, 0, 0}, {2, 0, 0}};
  EXPECT_EQ(DistancesWithin(grid, {0})[1],
            std::numeric_limits<double>::infinity());
  EXPECT_EQ(grid.Center(1), Eigen::RowVector3d(5, 1, 1));
  EXPECT_EQ(grid.CellOf({5.9, 1, -0.1}), (VoxelGrid::Cell{2, 0, -1}));
  EXPECT_EQ(grid.At({3, 0, 0}), -1);
  EXPECT_EQ(grid.At({0, 0, 1}), -1);
  // Two cells away, and three.
  EXPECT_EQ(grid.Nearest({9.9, 1, 1}), 1);
  EXPECT_EQ(grid.Nearest({10.1, 1, 1}), -1);
  EXPECT_EQ(grid.Nearest({-3.9, -3.9, 5.9}), 0);
  EXPECT_EQ(grid.Nearest({2.9, 1, 1}), 0);
  EXPECT_EQ(grid.Nearest({3.1, 1, 1}), 1);
}

}  // namespace
}  // namespace musclewarp
