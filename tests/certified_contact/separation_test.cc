// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/separation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "musclewarp/geometry/triangle_distance.h"
#include "musclewarp/geometry/triangle_intersection.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

constexpr double kGap = 0.1;
// Of coordinates of size 10, and what planes are set apart by on purpose.
constexpr double kRounding = 1e-8;

double Distance(const Corners& a, const Corners& b) {
  return std::sqrt(ClosestPointsOfTriangles(a, b).squared_distance);
}

double Lowest(const HalfSpace& space, const Corners& t) {
  return (t * space.normal.transpose()).minCoeff() - space.level;
}

double Highest(const HalfSpace& space, const Corners& t) {
  return (t * space.normal.transpose()).maxCoeff() - space.level;
}

// Small triangles around a sphere of radius 10, at most 3 from it.
std::vector<Corners> TrianglesAround(int count) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Corners> triangles;
  for (int i = 0; i < count; ++i) {
    const RowVector3d to(normal(random), normal(random), normal(random));
    Corners t;
    for (int k = 0; k < 3; ++k) {
      t.row(k) = to.normalized() * (10.3 + 2 * uniform(random)) +
                 RowVector3d(uniform(random), uniform(random), uniform(random));
    }
    triangles.push_back(t);
  }
  return triangles;
}

std::vector<int> All(const TriangleBvh& bvh) {
  std::vector<int> all(bvh.num_triangles());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

}  // namespace

TEST(PartFromObstacles, EveryObstacleInReachIsBehindAPlane) {
  const TriangleSoup sphere = Icosphere(10, 4);
  const TriangleBvh bvh(sphere.points, sphere.triangles);
  constexpr double kRadius = 2.5;
  int compared = 0;
  for (const Corners& t : TrianglesAround(200)) {
    double nearest = 1e300;
    for (int g = 0; g < bvh.num_triangles(); ++g) {
      nearest = std::min(nearest, Distance(t, bvh.corners(g)));
      if (TrianglesIntersect(t, bvh.corners(g))) nearest = 0;
    }
    if (nearest == 0) continue;
    std::vector<HalfSpace> spaces;
    const std::vector<int> near = All(bvh);
    PartFromObstacles(t,
                      bvh,
                      near.data(),
                      static_cast<int>(near.size()),
                      kRadius,
                      kGap,
                      &spaces);
    EXPECT_EQ(spaces.empty(), nearest > kRadius);
    for (const HalfSpace& space : spaces) {
      EXPECT_NEAR(space.normal.norm(), 1, 1e-12);
      if (nearest >= kGap) {
        EXPECT_GE(Lowest(space, t), -kRounding);
      }
    }
    for (int g = 0; g < bvh.num_triangles(); ++g) {
      if (Distance(t, bvh.corners(g)) > kRadius) continue;
      ++compared;
      double behind = -1e300;
      for (const HalfSpace& space : spaces) {
        behind = std::max(behind, -Highest(space, bvh.corners(g)));
      }
      EXPECT_GE(behind, 0.75 * kGap - kRounding);
    }
  }
  EXPECT_GT(compared, 1000);
}

TEST(PartFromObstacles, NeedsFewPlanesOverAFlatObstacle) {
  const TriangleSoup box = Box(20, 20, 2);
  const TriangleBvh bvh(box.points, box.triangles);
  Corners t;
  t << 9, 9, 2, 11, 9, 2, 9, 11, 2;
  const std::vector<int> near = All(bvh);
  std::vector<HalfSpace> spaces;
  PartFromObstacles(
      t, bvh, near.data(), static_cast<int>(near.size()), 5, kGap, &spaces);
  ASSERT_EQ(spaces.size(), 1u);
  EXPECT_LT((spaces[0].normal - RowVector3d(0, 0, 1)).norm(), 1e-12);
  // Half of the room above 1 beyond the gap is left.
  EXPECT_NEAR(spaces[0].level, 1 + kGap + (1 - kGap) / 2, kRounding);
}

TEST(PartFromObstacles, PartsFromThoseItIsAskedForOnly) {
  const TriangleSoup box = Box(20, 20, 2);
  const TriangleBvh bvh(box.points, box.triangles);
  Corners t;
  t << 9, 9, 2, 11, 9, 2, 9, 11, 2;
  for (int g = 0; g < bvh.num_triangles(); ++g) {
    std::vector<HalfSpace> spaces;
    PartFromObstacles(t, bvh, &g, 1, 5, kGap, &spaces);
    EXPECT_EQ(spaces.size(), Distance(t, bvh.corners(g)) <= 5 ? 1u : 0u);
    PartFromObstacles(t, bvh, &g, 0, 5, kGap, &spaces);
    EXPECT_LE(spaces.size(), 1u);
  }
}

TEST(PartedPairs, AreThoseOfAllPairs) {
  const TriangleSoup a = Icosphere(10, 3);
  TriangleSoup b = Icosphere(6, 3);
  b.points.rowwise() += RowVector3d(16.4, 0.3, 0.1);
  const TriangleBvh tree_a(a.points, a.triangles);
  const TriangleBvh tree_b(b.points, b.triangles);
  TriangleBvh moved_a = tree_a, moved_b = tree_b;
  // The second comes along the first.
  moved_b.Refit(b.points.rowwise() + RowVector3d(0, 3, 0));
  constexpr double kRadius = 2;
  std::set<std::pair<int, int>> expected;
  for (int f = 0; f < tree_a.num_triangles(); ++f) {
    for (int g = 0; g < tree_b.num_triangles(); ++g) {
      const bool is_near =
          Distance(tree_a.corners(f), tree_b.corners(g)) <= kRadius ||
          Distance(moved_a.corners(f), moved_b.corners(g)) <= kRadius;
      if (is_near) expected.emplace(f, g);
    }
  }
  std::set<std::pair<int, int>> found;
  for (const PartedPair& pair :
       PartedPairs(tree_a, tree_b, moved_a, moved_b, kRadius)) {
    found.emplace(pair.a, pair.b);
    const Corners& f = tree_a.corners(pair.a);
    const Corners& g = tree_b.corners(pair.b);
    EXPECT_NEAR(pair.distance, Distance(f, g), 1e-12);
    const double room = (f * pair.normal.transpose()).minCoeff() -
                        (g * pair.normal.transpose()).maxCoeff();
    EXPECT_NEAR(room, pair.distance, 1e-10);
  }
  EXPECT_EQ(found, expected);
  EXPECT_GT(found.size(), 20u);
}

TEST(Part, HasNoAnswerForTrianglesThatCross) {
  Corners a, b;
  a << 0, 0, 0, 4, 0, 0, 0, 4, 0;
  b << 1, 1, -1, 1, 1, 1, 1, 9, 1;
  PartedPair pair;
  EXPECT_FALSE(Part(a, b, &pair));
  b.col(2).array() += 2;
  EXPECT_TRUE(Part(a, b, &pair));
  EXPECT_EQ(pair.distance, 1);
  EXPECT_EQ(pair.normal, RowVector3d(0, 0, -1));
}

}  // namespace musclewarp
