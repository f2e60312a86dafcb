// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/triangle_bvh.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "support/meshes.h"

namespace musclewarp {
namespace {

using Pairs = std::set<std::pair<int, int>>;

bool BoxesOverlap(const TriangleBvh& a, int f, const TriangleBvh& b, int g) {
  for (int k = 0; k < 3; ++k) {
    const auto range = [k](const Corners& c) {
      return std::minmax({c(0, k), c(1, k), c(2, k)});
    };
    const auto [a_low, a_high] = range(a.corners(f));
    const auto [b_low, b_high] = range(b.corners(g));
    if (a_high < b_low || b_high < a_low) return false;
  }
  return true;
}

void ExpectAllOverlapsFound(const TriangleBvh& a, const TriangleBvh& b) {
  Pairs expected;
  for (int f = 0; f < a.num_triangles(); ++f) {
    for (int g = 0; g < b.num_triangles(); ++g) {
      if (BoxesOverlap(a, f, b, g)) expected.emplace(f, g);
    }
  }
  Pairs found;
  int visits = 0;
  a.ForEachOverlap(b, [&](int f, int g) {
    found.emplace(f, g);
    ++visits;
  });
  EXPECT_EQ(found, expected);
  EXPECT_EQ(visits, static_cast<int>(found.size())) << "a pair came twice";
}

}  // namespace

TEST(TriangleBvh, FindsEveryOverlapOnceAlsoAfterARefit) {
  const TriangleSoup a = Icosphere(10, 2);
  const TriangleSoup b = Spindle(4, 15, 2);
  TriangleBvh moving(a.points, a.triangles);
  const TriangleBvh still(b.points, b.triangles);
  ExpectAllOverlapsFound(moving, still);
  Points moved = 0.7 * a.points;
  moved.rowwise() += Eigen::RowVector3d(3, -4, 8);
  moving.Refit(moved);
  ExpectAllOverlapsFound(moving, still);
}

TEST(TriangleBvh, FindsEveryPairOfItsOwnOnce) {
  const TriangleSoup soup = Spindle(4, 15, 1);
  const TriangleBvh bvh(soup.points, soup.triangles);
  Pairs found;
  int visits = 0;
  bvh.ForEachSelfOverlap([&](int f, int g) {
    EXPECT_NE(f, g);
    found.insert(std::minmax(f, g));
    ++visits;
  });
  int expected = 0;
  for (int f = 0; f < bvh.num_triangles(); ++f) {
    for (int g = f + 1; g < bvh.num_triangles(); ++g) {
      expected += BoxesOverlap(bvh, f, bvh, g);
    }
  }
  EXPECT_EQ(visits, expected);
  EXPECT_EQ(static_cast<int>(found.size()), expected);
}

TEST(TriangleBvh, ClosestPointOfABox) {
  const TriangleSoup box = Box(2, 4, 6);
  const TriangleBvh bvh(box.points, box.triangles);
  std::mt19937 engine(9);
  for (int i = 0; i < 1000; ++i) {
    Eigen::RowVector3d p;
    for (int k = 0; k < 3; ++k) p[k] = 20 * (engine() / 4294967296.0) - 10;
    const Eigen::RowVector3d half(1, 2, 3);
    const Eigen::RowVector3d outside =
        (p.cwiseAbs() - half).cwiseMax(Eigen::RowVector3d::Zero());
    const double inside = (half - p.cwiseAbs()).minCoeff();
    const double expected = outside.norm() > 0 ? outside.norm() : inside;
    const TriangleBvh::Closest closest = bvh.ClosestPoint(p);
    ASSERT_GE(closest.triangle, 0);
    // A few roundings of coordinates below 10.
    EXPECT_NEAR(closest.distance, expected, 1e-13);
    EXPECT_NEAR((closest.point - p).norm(), closest.distance, 1e-13);
    const TriangleBvh::Closest bounded =
        bvh.ClosestPoint(p, expected * (1 - 1e-9));
    EXPECT_EQ(bounded.triangle, -1);
  }
}

TEST(TriangleBvh, AnEmptyMeshHasNothing) {
  const TriangleBvh empty(Points(0, 3), Triangles(0, 3));
  EXPECT_EQ(empty.ClosestPoint({0, 0, 0}).triangle, -1);
  empty.ForEachOverlap(empty, [](int, int) { FAIL(); });
}

}  // namespace musclewarp
