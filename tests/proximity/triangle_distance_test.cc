// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/proximity/triangle_distance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "musclewarp/cgal/triangle_intersection.h"
#include "support/triangles.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// The distance of places on a lattice on both triangles: too large by no more
// than the lattice is wide.
double SampledDistance(const Corners& a, const Corners& b, int steps) {
  double least = 1e300;
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; i + j <= steps; ++j) {
      const RowVector3d p = a.row(0) +
                            double(i) / steps * (a.row(1) - a.row(0)) +
                            double(j) / steps * (a.row(2) - a.row(0));
      least = std::min(least, (ClosestPointOfTriangle(p, b) - p).norm());
    }
  }
  return least;
}

TEST(TriangleDistance, KnowsCornersEdgesAndFaces) {
  const Corners a = CornersOf({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
  // A corner over the face.
  ClosestPair pair =
      ClosestPointsOfTriangles(a, CornersOf({1, 1, 3}, {1, 1, 5}, {2, 1, 5}));
  EXPECT_EQ(pair.squared_distance, 9);
  EXPECT_EQ(pair.on_a, RowVector3d(1, 1, 0));
  EXPECT_EQ(pair.on_b, RowVector3d(1, 1, 3));
  // Two edges that pass each other.
  pair = ClosestPointsOfTriangles(
      a, CornersOf({2, -1, -1}, {2, -1, 1}, {2, -9, 0}));
  EXPECT_EQ(pair.squared_distance, 1);
  EXPECT_EQ(pair.on_a, RowVector3d(2, 0, 0));
  // A corner and a corner.
  pair =
      ClosestPointsOfTriangles(a, CornersOf({7, 0, 4}, {9, 0, 4}, {9, 1, 9}));
  EXPECT_EQ(pair.squared_distance, 25);
}

TEST(TriangleDistance, IsThatOfSamplesAndTheSameBothWays) {
  // A few roundings of coordinates of size 1.
  constexpr double kRounding = 1e-14;
  std::mt19937 random(3);
  constexpr int kSteps = 40;
  int compared = 0;
  for (int i = 0; i < 400; ++i) {
    const Corners a = RandomTriangle(&random, 1);
    Corners b = RandomTriangle(&random, 1);
    b.rowwise() += RowVector3d(0.8, 0.3, 0.5);
    if (TrianglesIntersect(a, b)) continue;
    ++compared;
    const ClosestPair pair = ClosestPointsOfTriangles(a, b);
    const double distance = std::sqrt(pair.squared_distance);
    EXPECT_NEAR((pair.on_a - pair.on_b).norm(), distance, kRounding);
    EXPECT_LT((ClosestPointOfTriangle(pair.on_a, a) - pair.on_a).norm(),
              kRounding);
    EXPECT_LT((ClosestPointOfTriangle(pair.on_b, b) - pair.on_b).norm(),
              kRounding);
    const double sampled = SampledDistance(a, b, kSteps);
    EXPECT_LE(distance, sampled + kRounding);
    EXPECT_GE(distance, sampled - 4.0 / kSteps);
    EXPECT_NEAR(ClosestPointsOfTriangles(b, a).squared_distance,
                pair.squared_distance,
                kRounding);
  }
  EXPECT_GT(compared, 200);
}

TEST(TriangleDistance, TakesTrianglesWithoutArea) {
  const Corners a = CornersOf({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
  const RowVector3d p(1, 1, 2);
  EXPECT_EQ(ClosestPointsOfTriangles(a, CornersOf(p, p, p)).squared_distance,
            4);
  const RowVector3d q(3, 3, 5);
  EXPECT_EQ(ClosestPointsOfTriangles(CornersOf(p, q, p), a).squared_distance,
            4);
}

}  // namespace
}  // namespace musclewarp
