// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/proximity/triangle_grid.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "proximity/random_meshes.h"
#include "proximity/voxel_meshes.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// Moeller and Trumbore 1997; infinite for no hit.
double HitOf(const RowVector3d& p,
             const RowVector3d& direction,
             const TriangleSoup& soup) {
  double nearest = INFINITY;
  for (Eigen::Index f = 0; f < soup.triangles.rows(); ++f) {
    const RowVector3d a = soup.points.row(soup.triangles(f, 0));
    const RowVector3d ab = soup.points.row(soup.triangles(f, 1)) - a;
    const RowVector3d ac = soup.points.row(soup.triangles(f, 2)) - a;
    const RowVector3d h = direction.cross(ac);
    const double det = ab.dot(h);
    if (std::abs(det) < 1e-14) continue;
    const double u = (p - a).dot(h) / det;
    const RowVector3d q = (p - a).cross(ab);
    const double v = direction.dot(q) / det;
    const double t = ac.dot(q) / det;
    if (u >= 0 && v >= 0 && u + v <= 1 && t >= 0) {
      nearest = std::min(nearest, t);
    }
  }
  return nearest;
}

}  // namespace

TEST(TriangleGrid, FindsTheFirstHitOfBruteForce) {
  std::mt19937 random(1);
  for (const TriangleSoup& soup :
       {RandomSoup(300, 0.2, &random), Icosphere(0.8, 3)}) {
    const TriangleGrid grid(soup.points, soup.triangles);
    int hits = 0;
    for (int i = 0; i < 2000; ++i) {
      const RowVector3d p = RandomPoint(1.5, &random);
      const RowVector3d direction = RandomPoint(1, &random).normalized();
      const double expected = HitOf(p, direction, soup);
      const double hit = grid.FirstHit(p, direction);
      // Both divide numbers of size 1 by determinants above 1e-6.
      constexpr double kQuotient = 1e-8;
      if (std::isinf(expected)) {
        EXPECT_TRUE(std::isinf(hit));
      } else {
        EXPECT_NEAR(hit, expected, kQuotient);
        ++hits;
      }
    }
    EXPECT_GT(hits, 100);
  }
}

TEST(TriangleGrid, NoRayLeavesAClosedMeshUnseen) {
  const TriangleSoup soup = Icosphere(5, 2);
  const TriangleGrid grid(soup.points, soup.triangles);
  const RowVector3d p(0.1, -0.2, 0.3);
  for (Eigen::Index f = 0; f < soup.triangles.rows(); ++f) {
    const RowVector3d a = soup.points.row(soup.triangles(f, 0));
    const RowVector3d b = soup.points.row(soup.triangles(f, 1));
    for (const RowVector3d& aim : {a, RowVector3d(0.5 * (a + b))}) {
      const double hit = grid.FirstHit(p, (aim - p).normalized());
      // Rounding of the direction may meet the neighbour beside the edge.
      constexpr double kBesideEdge = 1e-9;
      EXPECT_NEAR(hit, (aim - p).norm(), kBesideEdge);
    }
  }
}

TEST(TriangleGrid, CountsRightOrSaysThatItCannot) {
  std::mt19937 random(2);
  int decided = 0;
  int undecided = 0;
  int on_surface = 0;
  for (int trial = 0; trial < 10; ++trial) {
    const VoxelSolid solid(3, 0.5, &random);
    const TriangleSoup soup = solid.Surface();
    const TriangleGrid grid(soup.points, soup.triangles);
    for (int i = 0; i < 13 * 13 * 13; ++i) {
      const RowVector3d p = 0.25 * RowVector3d(i % 13, i / 13 % 13, i / 169);
      if (!grid.BoxContains(p)) continue;
      // Along axes and diagonals most rays meet edges and corners.
      for (const RowVector3d& direction : {RowVector3d(1, 0, 0),
                                           RowVector3d(0, -1, 1),
                                           RowVector3d(1, 1, 1),
                                           RowVector3d(0.3, -0.5, 0.9)}) {
        switch (grid.CountCrossings(p, direction)) {
          case RayParity::kEven:
            EXPECT_FALSE(solid.Contains(p)) << p << " along " << direction;
            ++decided;
            break;
          case RayParity::kOdd:
            EXPECT_TRUE(solid.Contains(p)) << p << " along " << direction;
            ++decided;
            break;
          case RayParity::kOnSurface:
            EXPECT_FALSE(solid.Contains(p));
            ++on_surface;
            break;
          case RayParity::kUndecided:
            ++undecided;
        }
      }
    }
  }
  EXPECT_GT(decided, 1000);
  EXPECT_GT(undecided, 1000);
  EXPECT_GT(on_surface, 100);
}

TEST(TriangleGrid, EmptyCellsAreOnOneSide) {
  std::mt19937 random(3);
  const TriangleSoup soup = Icosphere(5, 3);
  const TriangleGrid grid(soup.points, soup.triangles);
  std::vector<int> side(grid.num_cells(), -1);
  for (int i = 0; i < 5000; ++i) {
    const RowVector3d p = RandomPoint(5, &random);
    if (!grid.BoxContains(p)) continue;
    const int cell = grid.EmptyCell(p);
    if (cell < 0) continue;
    const int is_odd =
        grid.CountCrossings(p, {0.1, 0.7, 0.2}) == RayParity::kOdd;
    if (side[cell] < 0) side[cell] = is_odd;
    EXPECT_EQ(side[cell], is_odd);
  }
}

TEST(TriangleGrid, TakesAnySoup) {
  // No triangles, one, a flat mesh, points in one place, one giant among small
  // ones, a long row.
  const auto hit = [](const TriangleSoup& soup) {
    return TriangleGrid(soup.points, soup.triangles)
        .FirstHit({0.1, 0.1, 10}, {0, 0, -1});
  };
  TriangleSoup soup;
  soup.points.resize(3, 3);
  soup.points << 0, 0, 0, 1, 0, 0, 0, 1, 0;
  soup.triangles.resize(0, 3);
  EXPECT_TRUE(std::isinf(hit(soup)));
  soup.triangles.resize(1, 3);
  soup.triangles << 0, 1, 2;
  EXPECT_DOUBLE_EQ(hit(soup), 10);

  TriangleSoup point = soup;
  point.points.setConstant(7);
  EXPECT_TRUE(std::isinf(hit(point)));

  TriangleSoup giant = Icosphere(0.01, 3);
  giant.points.rowwise() += RowVector3d(3, 3, 3);
  giant = Together(giant, soup);
  giant.points.bottomRows(3) *= 1e6;
  EXPECT_DOUBLE_EQ(hit(giant), 10);

  TriangleSoup row;
  row.points.resize(3 * 1000, 3);
  row.triangles.resize(1000, 3);
  for (int i = 0; i < 1000; ++i) {
    row.points.middleRows(3 * i, 3) =
        soup.points.rowwise() + RowVector3d(1e5 * i, 0, 0);
    row.triangles.row(i) << 3 * i, 3 * i + 1, 3 * i + 2;
  }
  EXPECT_DOUBLE_EQ(hit(row), 10);
  // Memory goes with the triangles, not with the box.
  EXPECT_LT(TriangleGrid(row.points, row.triangles).num_cells(), 100000);
  EXPECT_LT(TriangleGrid(giant.points, giant.triangles).num_cells(), 100000);
}

}  // namespace musclewarp
