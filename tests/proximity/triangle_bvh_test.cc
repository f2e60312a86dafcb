// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/proximity/triangle_bvh.h"
#include "musclewarp/proximity/triangle_distance.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "proximity/random_meshes.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

using PairSet = std::set<std::pair<int, int>>;

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
  PairSet expected;
  for (int f = 0; f < a.num_triangles(); ++f) {
    for (int g = 0; g < b.num_triangles(); ++g) {
      if (BoxesOverlap(a, f, b, g)) expected.emplace(f, g);
    }
  }
  PairSet found;
  int visits = 0;
  a.ForEachOverlap(b, [&](int f, int g) {
    found.emplace(f, g);
    ++visits;
  });
  EXPECT_EQ(found, expected);
  EXPECT_EQ(visits, static_cast<int>(found.size())) << "a pair came twice";
}

using Eigen::RowVector3d;
using PairList = std::vector<std::pair<int, int>>;

PairList Overlaps(const TriangleBvh& a, const TriangleBvh& b) {
  PairList pairs;
  a.ForEachOverlap(b, [&](int f, int g) { pairs.emplace_back(f, g); });
  return pairs;
}

PairList Sorted(PairList pairs) {
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

double DistanceByBruteForce(const TriangleBvh& bvh, const RowVector3d& p) {
  double least = INFINITY;
  for (int f = 0; f < bvh.num_triangles(); ++f) {
    least =
        std::min(least, (ClosestPointOfTriangle(p, bvh.corners(f)) - p).norm());
  }
  return least;
}

// No point of a fine sampling of the triangle is closer.
void ExpectClosest(const RowVector3d& p, const Corners& triangle) {
  const RowVector3d closest = ClosestPointOfTriangle(p, triangle);
  const double distance = (closest - p).norm();
  double least = INFINITY;
  double to_triangle = INFINITY;
  constexpr int kSteps = 200;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; i + j <= kSteps; ++j) {
      const RowVector3d sample = (i * triangle.row(0) + j * triangle.row(1) +
                                  (kSteps - i - j) * triangle.row(2)) /
                                 kSteps;
      least = std::min(least, (sample - p).norm());
      to_triangle = std::min(to_triangle, (sample - closest).norm());
    }
  }
  // Rounding of coordinates of size 10.
  constexpr double kRounding = 1e-14;
  // Half the spacing of samples on triangles up to 5 wide.
  constexpr double kSpacing = 5.0 / kSteps;
  EXPECT_LE(distance, least + kRounding) << triangle << "\n" << p;
  EXPECT_LE(to_triangle, kSpacing) << triangle << "\n" << p;
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

// With boxes given instead of those around the corners.
TEST(TriangleBvh, FindsPairsOfNodesThatMeetACondition) {
  const TriangleSoup a = Icosphere(1, 1);
  TriangleSoup b = Icosphere(1, 1);
  b.points.rowwise() += RowVector3d(2.5, 0, 0);
  const TriangleBvh tree_a(a.points, a.triangles);
  const TriangleBvh tree_b(b.points, b.triangles);
  EXPECT_TRUE(Overlaps(tree_a, tree_b).empty());
  constexpr double kMargin = 0.7;
  std::vector<Box3> boxes;
  PairSet expected;
  for (int f = 0; f < tree_a.num_triangles(); ++f) {
    boxes.push_back(BoxOf(tree_a.corners(f), kMargin));
    for (int g = 0; g < tree_b.num_triangles(); ++g) {
      if (boxes[f].Overlaps(BoxOf(tree_b.corners(g)))) expected.emplace(f, g);
    }
  }
  const std::vector<Box3> of_nodes = tree_a.BoxesOfNodes(boxes);
  const PairList found = tree_a.CollectPairs(
      tree_b,
      [&](int i, int k) { return of_nodes[i].Overlaps(tree_b.node_box(k)); },
      [](int, int) { return true; });
  EXPECT_EQ(PairSet(found.begin(), found.end()), expected);
  EXPECT_FALSE(found.empty());
  EXPECT_LT(found.size(), 80u * 80u);
}

TEST(TriangleBvh, BoxesOfNodesHoldThoseOfTheirTriangles) {
  const TriangleSoup sphere = Icosphere(10, 2);
  const TriangleBvh bvh(sphere.points, sphere.triangles);
  const int count = bvh.num_triangles();
  std::vector<Box3> numbers(count);
  for (int f = 0; f < count; ++f) {
    const double number = f;
    numbers[f] = {{number, number, number}, {number, number, number}};
  }
  const std::vector<Box3> boxes = bvh.BoxesOfNodes(numbers);
  // Only the nodes above a triangle may hold its number.
  for (const int wanted : {0, 17, count - 1}) {
    const Eigen::RowVector3d point = Eigen::RowVector3d::Constant(wanted);
    std::vector<int> reached;
    int nodes = 0;
    bvh.TraverseNodes(
        [&](int node) {
          ++nodes;
          return boxes[node].Contains(point);
        },
        [&](int f) { reached.push_back(f); });
    EXPECT_EQ(reached, std::vector<int>{wanted});
    EXPECT_LT(nodes, 2 * count - 1);
  }
}

TEST(TriangleBvh, FindsEveryPairOfItsOwnOnce) {
  const TriangleSoup soup = Spindle(4, 15, 1);
  const TriangleBvh bvh(soup.points, soup.triangles);
  PairSet found;
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
    constexpr double kRounding = 1e-13;
    EXPECT_NEAR(closest.distance, expected, kRounding);
    EXPECT_NEAR((closest.point - p).norm(), closest.distance, kRounding);
    // Shorter than the distance by more than rounding.
    constexpr double kShorter = 1 - 1e-9;
    const TriangleBvh::Closest bounded =
        bvh.ClosestPoint(p, expected * kShorter);
    EXPECT_EQ(bounded.triangle, -1);
  }
}

TEST(TriangleBvh, AnEmptyMeshHasNothing) {
  const TriangleBvh empty(Points(0, 3), Triangles(0, 3));
  EXPECT_EQ(empty.ClosestPoint({0, 0, 0}).triangle, -1);
  empty.ForEachOverlap(empty, [](int, int) { FAIL(); });
}

TEST(TriangleBvh, CollectingKeepsWhatTheFilterKeeps) {
  std::mt19937 random(3);
  const TriangleSoup a = RandomSoup(700, 0.1, &random);
  const TriangleSoup b = RandomSoup(500, 0.1, &random);
  const TriangleBvh bvh_a(a.points, a.triangles);
  const TriangleBvh bvh_b(b.points, b.triangles);
  const auto keep = [](int f, int g) { return (f + g) % 3 == 0; };
  PairList expected, expected_self;
  for (const auto& [f, g] : Overlaps(bvh_a, bvh_b)) {
    if (keep(f, g)) expected.emplace_back(f, g);
  }
  bvh_a.ForEachSelfOverlap([&](int f, int g) {
    if (keep(f, g)) expected_self.push_back(std::minmax(f, g));
  });
  PairList self = bvh_a.CollectSelfOverlaps(keep);
  for (auto& [f, g] : self) {
    if (f > g) std::swap(f, g);
  }
  EXPECT_EQ(Sorted(bvh_a.CollectOverlaps(bvh_b, keep)), Sorted(expected));
  EXPECT_EQ(Sorted(self), Sorted(expected_self));
}

TEST(TriangleBvh, PairsOfItsOwnAreThoseOfTheNodesThatAreEntered) {
  const TriangleSoup sphere = Icosphere(10, 2);
  const TriangleBvh tree(sphere.points, sphere.triangles);
  const auto all = [](int, int) { return true; };
  const auto count = static_cast<size_t>(sphere.triangles.rows());
  const auto pairs = tree.CollectSelfPairs(all, all);
  EXPECT_EQ(pairs.size(), count * (count - 1) / 2);
  EXPECT_EQ(PairSet(pairs.begin(), pairs.end()).size(), pairs.size());
  EXPECT_TRUE(std::is_sorted(pairs.begin(), pairs.end()));
  PairSet overlapping;
  tree.ForEachSelfOverlap(
      [&](int f, int g) { overlapping.insert(std::minmax(f, g)); });
  const auto entered = tree.CollectSelfPairs(
      [&](int a, int b) { return tree.node_box(a).Overlaps(tree.node_box(b)); },
      all);
  EXPECT_EQ(PairSet(entered.begin(), entered.end()), overlapping);
}

TEST(TriangleBvh, TheOrderDoesNotDependOnTheThreads) {
  std::mt19937 random(4);
  const TriangleSoup soup = RandomSoup(600, 0.2, &random);
  const TriangleBvh bvh(soup.points, soup.triangles);
  const auto keep = [](int, int) { return true; };
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const PairList one = bvh.CollectOverlaps(bvh, keep);
  omp_set_num_threads(4);
  const PairList four = bvh.CollectOverlaps(bvh, keep);
  omp_set_num_threads(threads);
  EXPECT_EQ(one, four);
}

TEST(TriangleBvh, ClosestPointIsThatOfAllTriangles) {
  std::mt19937 random(6);
  const TriangleSoup soup = RandomSoup(300, 0.2, &random);
  const TriangleBvh bvh(soup.points, soup.triangles);
  for (int i = 0; i < 300; ++i) {
    const RowVector3d p = RandomPoint(2, &random);
    const auto closest = bvh.ClosestPoint(p);
    EXPECT_EQ(closest.distance, DistanceByBruteForce(bvh, p));
    EXPECT_EQ(closest.distance, (closest.point - p).norm());
    EXPECT_EQ(closest.point,
              ClosestPointOfTriangle(p, bvh.corners(closest.triangle)));
  }
}

TEST(TriangleBvh, NothingIsCloseOutsideTheRadius) {
  const TriangleSoup sphere = Icosphere(10, 2);
  const TriangleBvh bvh(sphere.points, sphere.triangles);
  const RowVector3d p = 2 * sphere.points.row(0);
  EXPECT_EQ(bvh.ClosestPoint(p, 9.99).triangle, -1);
  EXPECT_EQ(bvh.ClosestPoint(p, 9.99).distance, INFINITY);
  const auto closest = bvh.ClosestPoint(p, 10.01);
  EXPECT_EQ(closest.distance, bvh.ClosestPoint(p).distance);
  // The radius itself counts.
  EXPECT_EQ(bvh.ClosestPoint(p, closest.distance).distance, closest.distance);
}

TEST(TriangleBvh, TellsWhatIsWithinADistance) {
  const TriangleSoup box = Box(2, 2, 2);
  const TriangleBvh bvh(box.points, box.triangles);
  const RowVector3d above(0.3, 0.2, 4);
  EXPECT_TRUE(bvh.IsWithin(above, 3));
  EXPECT_FALSE(bvh.IsWithin(above, 2.999));
  EXPECT_TRUE(bvh.IsWithin({0.3, 0.2, 1}, 1e-12)) << "on the surface";
  EXPECT_FALSE(bvh.IsWithin({0.3, 0.2, 1}, -1));
}

TEST(TriangleBvh, CoincidentTrianglesAreToldApart) {
  TriangleSoup soup;
  soup.points = UnitTetrahedron().points;
  soup.triangles.resize(64, 3);
  for (int f = 0; f < 64; ++f) soup.triangles.row(f) << 0, 1, 2;
  const TriangleBvh bvh(soup.points, soup.triangles);
  int pairs = 0;
  bvh.ForEachSelfOverlap([&](int, int) { ++pairs; });
  EXPECT_EQ(pairs, 64 * 63 / 2);
}

TEST(ClosestPointOfTriangle, AnyPlacementOnTheGrid) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> coordinate(-1, 3);
  for (int i = 0; i < 200; ++i) {
    const RowVector3d p(
        coordinate(random), coordinate(random), coordinate(random));
    ExpectClosest(p, RandomGridTriangle(2, &random));
  }
}

TEST(ClosestPointOfTriangle, Needles) {
  std::mt19937 random(8);
  for (const double width : {1e-3, 1e-6, 1e-9, 1e-12, 0.0}) {
    for (int i = 0; i < 20; ++i) {
      Corners needle;
      needle.row(0) = RandomPoint(1, &random);
      needle.row(1) = RandomPoint(1, &random);
      needle.row(2) =
          (needle.row(0) + needle.row(1)) / 2 + RandomPoint(width, &random);
      ExpectClosest(RandomPoint(2, &random), needle);
    }
  }
}

}  // namespace musclewarp
