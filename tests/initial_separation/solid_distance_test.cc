// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/initial_separation/solid_distance.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "initial_separation/solid.h"
#include "musclewarp/base/infinity.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

double SearchedEverywhere(const SearchableMesh& mesh, const RowVector3d& p) {
  const double distance = mesh.bvh().ClosestPoint(p).distance;
  return mesh.winding().IsInside(p) ? -distance : distance;
}

// Compares distances at random places in a cube around a mesh.
void ExpectAsSearched(TriangleSoup soup, double half_size, double limit) {
  const SearchableMesh mesh(std::move(soup));
  const SolidDistance distance(mesh);
  int num_inside = 0, num_limited = 0;
  const Points places = half_size * RandomPoints(2000, 7);
  for (const auto p : places.rowwise()) {
    const double expected = std::min(SearchedEverywhere(mesh, p), limit);
    ASSERT_EQ(distance.At(p, limit), expected) << p;
    ASSERT_LE(expected, distance.UpperBound(p) + kDistanceRounding) << p;
    num_inside += expected < 0;
    num_limited += expected == limit;
  }
  EXPECT_GT(num_inside, 0);
  if (limit < half_size) {
    EXPECT_GT(num_limited, 0);
  }
}

}  // namespace

TEST(SolidDistance, IsTheSearchedOneAroundASphere) {
  ExpectAsSearched(MovedBy(Icosphere(15, 3), {3, 2, 1}), 25, kInfinity);
}

TEST(SolidDistance, IsTheSearchedOneInAndAroundABoxOfFewTriangles) {
  ExpectAsSearched(Box(30, 8, 20), 18, kInfinity);
}

TEST(SolidDistance, IsTheSearchedOneFarAway) {
  ExpectAsSearched(Icosphere(15, 2), 80, kInfinity);
}

TEST(SolidDistance, IsNoMoreThanTheLimitOutside) {
  ExpectAsSearched(Icosphere(15, 3), 25, 3);
  ExpectAsSearched(Box(30, 8, 20), 25, 0.5);
}

TEST(SolidDistance, KnowsTwoSheetsBetweenTwoSamples) {
  // A plate of 0.3 mm is thinner than the way between samples.
  ExpectAsSearched(Box(40, 40, 0.3), 20, kInfinity);
}

TEST(SolidDistance, IsBoundedByItsSamples) {
  const SearchableMesh mesh(Icosphere(30, 3));
  const SolidDistance distance(mesh);
  // By the way to the nearest sample, at most 1.5 mm along each axis.
  EXPECT_LT(distance.UpperBound({0, 0, 28}), 1);
  EXPECT_LT(distance.UpperBound({1, 1, 1}), -10);
  EXPECT_EQ(distance.UpperBound({100, 0, 0}), kInfinity);
}

TEST(SolidDistance, IsExactInsideWhateverTheLimit) {
  const SearchableMesh mesh(Box(30, 30, 30));
  const SolidDistance distance(mesh);
  EXPECT_EQ(distance.At({0, 0, 0}, 1), -15);
  EXPECT_EQ(distance.At({0, 0, 18}, 1), 1);
  EXPECT_EQ(distance.At({0, 0, 18}, 5), 3);
}

}  // namespace musclewarp
