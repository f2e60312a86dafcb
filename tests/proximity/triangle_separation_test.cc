// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/proximity/triangle_separation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

#include "musclewarp/cgal/triangle_intersection.h"
#include "musclewarp/proximity/triangle_distance.h"
#include "proximity/triangle_distances.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

constexpr double kGap = 0.1;
// Of coordinates of size 10, and what planes are set apart by on purpose.
constexpr double kSeparationRounding = 1e-8;

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

ObstacleOptions Within(double radius) {
  ObstacleOptions options;
  options.radius = radius;
  options.gap = kGap;
  return options;
}

std::vector<int> All(const TriangleBvh& bvh) {
  std::vector<int> all(bvh.num_triangles());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

}  // namespace

TEST(SeparateFromObstacles, EveryObstacleInReachIsBehindAPlane) {
  const TriangleSoup sphere = Icosphere(10, 4);
  const TriangleBvh bvh(sphere.points, sphere.triangles);
  constexpr double kRadius = 2.5;
  int compared = 0;
  for (const Corners& t : TrianglesAround(200)) {
    double nearest = 1e300;
    for (int g = 0; g < bvh.num_triangles(); ++g) {
      nearest = std::min(nearest, DistanceOf(t, bvh.corners(g)));
      if (TrianglesIntersect(t, bvh.corners(g))) nearest = 0;
    }
    if (nearest == 0) continue;
    const std::vector<int> near = All(bvh);
    const ObstacleSeparation separation = SeparateFromObstacles(
        t, bvh, near.data(), static_cast<int>(near.size()), Within(kRadius));
    const std::vector<HalfSpace>& spaces = separation.spaces;
    EXPECT_EQ(spaces.empty(), nearest > kRadius);
    EXPECT_EQ(separation.distance > kRadius, spaces.empty());
    if (!spaces.empty()) {
      EXPECT_LE(separation.distance, nearest + kSeparationRounding);
    }
    for (const HalfSpace& space : spaces) {
      EXPECT_NEAR(space.normal.norm(), 1, 1e-12);
      if (nearest >= kGap) {
        EXPECT_GE(Lowest(space, t), -kSeparationRounding);
      }
    }
    for (int g = 0; g < bvh.num_triangles(); ++g) {
      if (DistanceOf(t, bvh.corners(g)) > kRadius) continue;
      ++compared;
      double behind = -1e300;
      for (const HalfSpace& space : spaces) {
        behind = std::max(behind, -Highest(space, bvh.corners(g)));
      }
      EXPECT_GE(behind, 0.75 * kGap - kSeparationRounding);
    }
  }
  EXPECT_GT(compared, 1000);
}

TEST(SeparateFromObstacles, NeedsOnePlaneOverAFlatObstacle) {
  const TriangleSoup box = Box(20, 20, 2);
  const TriangleBvh bvh(box.points, box.triangles);
  Corners t;
  t << 9, 9, 2, 11, 9, 2, 9, 11, 2;
  const std::vector<int> near = All(bvh);
  const std::vector<HalfSpace> spaces =
      SeparateFromObstacles(
          t, bvh, near.data(), static_cast<int>(near.size()), Within(5))
          .spaces;
  ASSERT_EQ(spaces.size(), 1u);
  EXPECT_LT((spaces[0].normal - RowVector3d(0, 0, 1)).norm(), 1e-12);
  // Half of the room above 1 beyond the gap is left.
  EXPECT_NEAR(spaces[0].level, 1 + kGap + (1 - kGap) / 2, kSeparationRounding);
}

// A triangle within a sphere needs planes all around.
TEST(SeparateFromObstacles, FindsNoMorePlanesThanAllowedTheNearestFirst) {
  const TriangleSoup sphere = Icosphere(10, 3);
  const TriangleBvh bvh(sphere.points, sphere.triangles);
  const std::vector<int> near = All(bvh);
  Corners t;
  t << 3, 1, 0.5, 4, 1.5, 0, 3, 2, 1;
  const auto planes_within = [&](size_t max_planes) {
    ObstacleOptions options = Within(20);
    options.max_planes = static_cast<int>(max_planes);
    return SeparateFromObstacles(
               t, bvh, near.data(), static_cast<int>(near.size()), options)
        .spaces;
  };
  const std::vector<HalfSpace> all = planes_within(1000);
  ASSERT_GT(all.size(), 4u);
  for (size_t most = 0; most < all.size() + 2; ++most) {
    const std::vector<HalfSpace> spaces = planes_within(most);
    ASSERT_EQ(spaces.size(), std::min(most, all.size()));
    for (size_t i = 0; i < spaces.size(); ++i) {
      EXPECT_EQ(spaces[i].normal, all[i].normal);
      EXPECT_EQ(spaces[i].level, all[i].level);
    }
  }
}

TEST(SeparateFromObstacles, LooksAtTheGivenTrianglesOnly) {
  const TriangleSoup box = Box(20, 20, 2);
  const TriangleBvh bvh(box.points, box.triangles);
  Corners t;
  t << 9, 9, 2, 11, 9, 2, 9, 11, 2;
  for (int g = 0; g < bvh.num_triangles(); ++g) {
    EXPECT_EQ(SeparateFromObstacles(t, bvh, &g, 1, Within(5)).spaces.size(),
              DistanceOf(t, bvh.corners(g)) <= 5 ? 1u : 0u);
    EXPECT_TRUE(SeparateFromObstacles(t, bvh, &g, 0, Within(5)).spaces.empty());
  }
}

TEST(AreSurelyFarther, IsNeverWrongAndSeesMost) {
  const std::vector<Corners> triangles = TrianglesAround(200);
  int farther = 0, seen = 0;
  for (const Corners& a : triangles) {
    for (const Corners& b : triangles) {
      const double square = ClosestPointsOfTriangles(a, b).squared_distance;
      EXPECT_FALSE(AreSurelyFarther(a, b, square));
      EXPECT_FALSE(AreSurelyFarther(a, b, 4 * square));
      if (square == 0) continue;
      ++farther;
      seen += AreSurelyFarther(a, b, square / 2);
    }
  }
  EXPECT_GT(seen, 0.9 * farther);
}

TEST(SeparateTriangles, HasNoAnswerForTrianglesThatCross) {
  Corners a, b;
  a << 0, 0, 0, 4, 0, 0, 0, 4, 0;
  b << 1, 1, -1, 1, 1, 1, 1, 9, 1;
  EXPECT_FALSE(SeparateTriangles(a, b).has_value());
  b.col(2).array() += 2;
  const auto separation = SeparateTriangles(a, b);
  ASSERT_TRUE(separation.has_value());
  EXPECT_EQ(separation->distance, 1);
  EXPECT_EQ(separation->normal, RowVector3d(0, 0, -1));
}

TEST(SeparateTriangles, IsTheSameToTheBitInTheOtherOrder) {
  const std::vector<Corners> triangles = TrianglesAround(40);
  int separated = 0;
  for (const Corners& a : triangles) {
    for (const Corners& b : triangles) {
      const auto one = SeparateTriangles(a, b);
      const auto two = SeparateTriangles(b, a);
      ASSERT_EQ(one.has_value(), two.has_value());
      if (!one) continue;
      ++separated;
      EXPECT_EQ(one->normal, -two->normal);
      EXPECT_EQ(one->distance, two->distance);
      // All of a is above all of b, by the distance.
      EXPECT_NEAR((a * one->normal.transpose()).minCoeff() -
                      (b * one->normal.transpose()).maxCoeff(),
                  one->distance,
                  kSeparationRounding);
    }
  }
  EXPECT_GT(separated, 1000);
}

// Two triangles that open like a book from a common corner.
TEST(SeparateSheets, HasTheOtherCornersOnEitherSideOfTheCommonOne) {
  Points points(5, 3);
  points << 0, 0, 0, 4, -1, 0.5, 4, 1, 0.5, 4, -1, -0.5, 4, 1, -0.5;
  const Eigen::RowVector3i a(0, 1, 2), b(3, 4, 0);
  const auto separation = SeparateSheets(points, a, b);
  ASSERT_TRUE(separation.has_value());
  EXPECT_LT((separation->normal - RowVector3d(0, 0, 1)).norm(), 1e-12);
  EXPECT_NEAR(separation->distance, 0.5, 1e-12);
}

TEST(SeparateSheets, HasNoAnswerForACommonEdgeOrSheetsThatCross) {
  Points points(5, 3);
  points << 0, 0, 0, 4, -1, 0, 4, 1, 0, 4, 0, -1, 4, 0, 1;
  EXPECT_FALSE(SeparateSheets(points, {0, 1, 2}, {0, 3, 4}).has_value());
  EXPECT_FALSE(SeparateSheets(points, {0, 1, 2}, {2, 1, 3}).has_value());
}

TEST(SeparateSheets, OfTrianglesWithoutACommonCornerIsThatOfTriangles) {
  Points points(6, 3);
  points << 0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, 2, 1, 9, 3, 9, 1, 3;
  const auto sheets = SeparateSheets(points, {0, 1, 2}, {3, 4, 5});
  const auto triangles =
      SeparateTriangles(points.topRows(3), points.bottomRows(3));
  ASSERT_TRUE(sheets.has_value());
  EXPECT_EQ(sheets->normal, triangles->normal);
  EXPECT_EQ(sheets->distance, triangles->distance);
}

}  // namespace musclewarp
