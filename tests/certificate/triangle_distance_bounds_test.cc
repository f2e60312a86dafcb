// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certificate/triangle_distance_bounds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "certificate/exact_distance.h"
#include "support/triangles.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// Expects that the exact distance is between the bounds.
void ExpectProved(const DistanceBounds& bounds,
                  const Corners& a,
                  const Corners& b) {
  const CGAL::Exact_rational squared = ExactSquaredDistance(a, b);
  const CGAL::Exact_rational least = bounds.at_least, most = bounds.at_most;
  EXPECT_TRUE(least * least <= squared)
      << bounds.at_least << " for " << std::sqrt(CGAL::to_double(squared));
  EXPECT_TRUE(squared <= most * most)
      << bounds.at_most << " for " << std::sqrt(CGAL::to_double(squared));
}

void ExpectDistance(const Corners& a, const Corners& b, double distance) {
  const DistanceBounds bounds = BoundDistance(a, b);
  EXPECT_LE(bounds.at_least, distance);
  EXPECT_GE(bounds.at_most, distance);
  EXPECT_LT(bounds.at_most - bounds.at_least, kTight);
}

TEST(BoundDistance, KnowsCornersEdgesAndFaces) {
  const Corners a = CornersOf({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
  // A corner over the face.
  ExpectDistance(a, CornersOf({1, 1, 3}, {1, 1, 5}, {2, 1, 5}), 3);
  // Two edges that pass each other.
  ExpectDistance(a, CornersOf({2, -1, -1}, {2, -1, 1}, {2, -9, 0}), 1);
  // A corner and an edge, and two corners.
  ExpectDistance(a, CornersOf({2, -3, 4}, {1, -9, 9}, {3, -9, 9}), 5);
  ExpectDistance(a, CornersOf({7, 0, 4}, {9, 0, 4}, {9, 1, 9}), 5);
  // Parallel faces, and parallel edges beside each other.
  ExpectDistance(a, CornersOf({0, 0, 0.5}, {4, 0, 0.5}, {0, 4, 0.5}), 0.5);
  ExpectDistance(a, CornersOf({1, -2, 0}, {3, -2, 0}, {2, -4, 0}), 2);
}

TEST(BoundDistance, NamesTheMiddleBetweenTheClosestPoints) {
  const DistanceBounds bounds =
      BoundDistance(CornersOf({0, 0, 0}, {4, 0, 0}, {0, 4, 0}),
                    CornersOf({1, 1, 3}, {1, 1, 5}, {2, 1, 5}));
  EXPECT_LT((bounds.place - RowVector3d(1, 1, 1.5)).norm(), kTight);
}

TEST(BoundDistance, ContainsTheExactDistance) {
  std::mt19937 random(7);
  for (int i = 0; i < 400; ++i) {
    const Corners a = RandomTriangle(&random, 1);
    Corners b = RandomTriangle(&random, 1);
    b.rowwise() += RowVector3d(0.8, 0.3, 0.5);
    const DistanceBounds bounds = BoundDistance(a, b);
    ExpectProved(bounds, a, b);
    EXPECT_LT(bounds.at_most - bounds.at_least, kTight);
  }
}

TEST(BoundDistance, ContainsTheExactDistanceFarFromTheOrigin) {
  // Coordinates are off the origin by up to 1e9 mm, so that they are multiples
  // of 1e-7 mm. What they are then counts exactly, and the bounds are as tight.
  std::mt19937 random(8);
  for (const double offset : {1e3, 1e6, 1e9}) {
    for (int i = 0; i < 60; ++i) {
      Corners a = RandomTriangle(&random, 1), b = RandomTriangle(&random, 1);
      a.rowwise() += offset * RowVector3d(1, -0.7, 0.3);
      b.rowwise() += offset * RowVector3d(1, -0.7, 0.3) + RowVector3d(1, 1, 0);
      const DistanceBounds bounds = BoundDistance(a, b);
      ExpectProved(bounds, a, b);
      EXPECT_LT(bounds.at_most - bounds.at_least, kTight);
    }
  }
}

TEST(BoundDistance, ContainsTheExactDistanceOfTrianglesThatAlmostTouch) {
  // b is a with some of its corners lifted off the plane, and all a hair. The
  // direction of the closest points is badly conditioned.
  std::mt19937 random(9);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const double hair : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15}) {
    for (int i = 0; i < 60; ++i) {
      const Corners a = RandomTriangle(&random, 5);
      const RowVector3d normal = AreaVector(a).normalized();
      Corners b = a;
      for (int k = i % 3; k < 3; ++k) {
        b.row(k) += std::abs(uniform(random)) * normal;
      }
      b.rowwise() += hair * normal;
      const DistanceBounds bounds = BoundDistance(a, b);
      ExpectProved(bounds, a, b);
      EXPECT_LT(bounds.at_most - bounds.at_least, kTight) << hair;
    }
  }
}

TEST(BoundDistance, ContainsTheExactDistanceOfEdgesThatAlmostTouch) {
  // An edge passes over another one, and the third corners are below and above:
  // no face separates the triangles, only the common normal of the edges.
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(0.1, 1);
  for (const double hair : {1e-3, 1e-6, 1e-9, 1e-12}) {
    for (int i = 0; i < 60; ++i) {
      const Corners frame = RandomTriangle(&random, 3);
      const RowVector3d u = frame.row(0), v = frame.row(1);
      const RowVector3d normal = u.cross(v).normalized();
      const Corners a = CornersOf(-uniform(random) * u,
                                  uniform(random) * u,
                                  -normal - uniform(random) * v);
      Corners b = CornersOf(-uniform(random) * v,
                            uniform(random) * v,
                            normal + uniform(random) * u);
      b.rowwise() += hair * normal;
      const DistanceBounds bounds = BoundDistance(a, b);
      ExpectProved(bounds, a, b);
      EXPECT_LT(bounds.at_most - bounds.at_least, kTight) << hair;
    }
  }
}

TEST(BoundDistance, IsTheSameBothWays) {
  std::mt19937 random(10);
  for (int i = 0; i < 200; ++i) {
    const Corners a = RandomTriangle(&random, 1);
    Corners b = RandomTriangle(&random, 1);
    b.rowwise() += RowVector3d(0.8, 0.3, 0.5);
    const DistanceBounds ab = BoundDistance(a, b), ba = BoundDistance(b, a);
    EXPECT_EQ(ab.at_least, ba.at_least);
    EXPECT_EQ(ab.at_most, ba.at_most);
    EXPECT_EQ(ab.place, ba.place);
  }
}

TEST(BoundDistance, IsZeroForTrianglesThatShareAPoint) {
  const Corners a = CornersOf({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
  for (const Corners& b : {CornersOf({1, 1, -1}, {1, 1, 1}, {2, 1, 5}),
                           CornersOf({1, 1, 0}, {1, 1, 1}, {2, 1, 5}),
                           CornersOf({4, 0, 0}, {9, 0, 0}, {9, 1, 9}),
                           a}) {
    const DistanceBounds bounds = BoundDistance(a, b);
    EXPECT_EQ(bounds.at_least, 0);
    EXPECT_EQ(bounds.at_most, 0);
  }
}

TEST(BoundDistance, TrianglesWithoutAreaAreSegmentsAndPoints) {
  const Corners a = CornersOf({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
  ExpectDistance(a, CornersOf({1, 1, 3}, {1, 1, 3}, {1, 1, 3}), 3);
  ExpectDistance(a, CornersOf({1, 1, 3}, {1, 1, 4}, {1, 1, 5}), 3);
  ExpectDistance(CornersOf({0, 0, 0}, {4, 0, 0}, {2, 0, 0}),
                 CornersOf({1, -1, 2}, {1, 1, 2}, {1, 3, 2}),
                 2);
}

TEST(BoundDistance, BeyondTheReachProvesOnlyThat) {
  const Corners a = CornersOf({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
  const Corners b = CornersOf({1, 1, 3}, {1, 1, 5}, {2, 1, 5});
  const DistanceBounds bounds = BoundDistance(a, b, /*reach=*/2);
  EXPECT_GT(bounds.at_least, 2);
  EXPECT_LE(bounds.at_least, 3);
  EXPECT_GE(bounds.at_most, 3);
}

}  // namespace
}  // namespace musclewarp
