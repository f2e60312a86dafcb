// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certificate/crossing_triangles.h"

#include <gtest/gtest.h>

#include <random>
#include <utility>
#include <vector>

#include "certificate/surface_views.h"
#include "musclewarp/cgal/triangle_intersection.h"
#include "musclewarp/proximity/mesh_intersection.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

using PairList = std::vector<std::pair<int, int>>;

PairList PairsOf(const std::vector<CrossingPair>& all, int a, int b) {
  PairList pairs;
  for (const CrossingPair& pair : all) {
    if (pair.a == a && pair.b == b) pairs.emplace_back(pair.f, pair.g);
  }
  return pairs;
}

// Triangles in a box of 40 mm, of very different sizes.
TriangleSoup RandomTriangles(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-20, 20), unit(-1, 1),
      exponent(-1, 1.2);
  TriangleSoup soup;
  soup.points.resize(3 * count, 3);
  soup.triangles.resize(count, 3);
  for (int f = 0; f < count; ++f) {
    const Eigen::RowVector3d at(place(random), place(random), place(random));
    const double size = std::pow(10, exponent(random));
    for (int k = 0; k < 3; ++k) {
      soup.triangles(f, k) = 3 * f + k;
      soup.points.row(3 * f + k) =
          at +
          size * Eigen::RowVector3d(unit(random), unit(random), unit(random));
    }
  }
  return soup;
}

TEST(CrossingTriangles, FindsWhatBruteForceAndTreesFind) {
  const std::vector<TriangleSoup> soups = {RandomTriangles(400, 1),
                                           RandomTriangles(300, 2),
                                           RandomTriangles(500, 3)};
  const auto all = CrossingTriangles({ViewOf(soups[0]), ViewOf(soups[1])},
                                     {ViewOf(soups[2])});
  size_t count = 0;
  const auto corners = [&](int mesh, int f) {
    Corners t;
    for (int k = 0; k < 3; ++k) {
      t.row(k) = soups[mesh].points.row(soups[mesh].triangles(f, k));
    }
    return t;
  };
  for (const auto& [a, b] : PairList{{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}}) {
    PairList expected;
    for (int f = 0; f < soups[a].triangles.rows(); ++f) {
      for (int g = a == b ? f + 1 : 0; g < soups[b].triangles.rows(); ++g) {
        if (a == b
                ? TrianglesIntersectBeyondCommon(corners(a, f), corners(b, g))
                : TrianglesIntersect(corners(a, f), corners(b, g))) {
          expected.emplace_back(f, g);
        }
      }
    }
    EXPECT_GT(expected.size(), 10u);
    EXPECT_EQ(PairsOf(all, a, b), expected) << a << b;
    EXPECT_EQ(expected,
              a == b ? SelfIntersections(soups[a])
                     : IntersectMeshes(soups[a], soups[b]).triangle_pairs);
    count += expected.size();
  }
  EXPECT_EQ(all.size(), count);
}

TEST(CrossingTriangles, TouchingIsCrossing) {
  // Two boxes that share a face, and two a hair apart.
  TriangleSoup a = Box(10, 10, 10), b = Box(10, 10, 10);
  b.points.rowwise() += Eigen::RowVector3d(10, 0, 0);
  EXPECT_GT(CrossingTriangles({ViewOf(a)}, {ViewOf(b)}).size(), 0u);
  b.points.rowwise() += Eigen::RowVector3d(1e-12, 0, 0);
  EXPECT_EQ(CrossingTriangles({ViewOf(a)}, {ViewOf(b)}).size(), 0u);
}

TEST(CrossingTriangles, NothingIsNoTrouble) {
  const TriangleSoup ball = Icosphere(3, 1);
  const TriangleSoup nothing;
  EXPECT_TRUE(CrossingTriangles({}, {ViewOf(ball)}).empty());
  EXPECT_TRUE(CrossingTriangles({ViewOf(nothing)}, {ViewOf(ball)}).empty());
  EXPECT_TRUE(CrossingTriangles({ViewOf(ball)}, {}).empty());
}

}  // namespace
}  // namespace musclewarp
