// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/cgal/triangle_intersection.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangle_3.h>
#include <CGAL/intersections.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "proximity/exact_intersection.h"
#include "proximity/random_meshes.h"
#include "support/triangles.h"

namespace musclewarp {
namespace {

using Row = Eigen::RowVector3d;
using Triangle = std::array<Row, 3>;

bool Intersect(const Triangle& a, const Triangle& b) {
  return TrianglesIntersect(a[0], a[1], a[2], b[0], b[1], b[2]);
}

// The same question to another library, in exact arithmetic.
bool IntersectByCgal(const Triangle& a, const Triangle& b) {
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  const auto point = [](const Row& p) {
    return Kernel::Point_3(p[0], p[1], p[2]);
  };
  return CGAL::do_intersect(
      Kernel::Triangle_3(point(a[0]), point(a[1]), point(a[2])),
      Kernel::Triangle_3(point(b[0]), point(b[1]), point(b[2])));
}

// All orders of corners and both orders of triangles have one answer.
void ExpectIntersect(const Triangle& a, const Triangle& b, bool expected) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Triangle turned_a = {a[i], a[(i + 1) % 3], a[(i + 2) % 3]};
      const Triangle turned_b = {b[j], b[(j + 2) % 3], b[(j + 1) % 3]};
      EXPECT_EQ(Intersect(turned_a, turned_b), expected);
      EXPECT_EQ(Intersect(turned_b, turned_a), expected);
    }
  }
}

const Triangle kFlat = {Row(0, 0, 0), Row(4, 0, 0), Row(0, 4, 0)};

Triangle Shifted(const Triangle& triangle, const Row& by) {
  return {triangle[0] + by, triangle[1] + by, triangle[2] + by};
}

using Eigen::RowVector3d;

// On the grid, exact in floating point.
bool HasArea(const Corners& t) {
  const RowVector3d u = t.row(1) - t.row(0);
  const RowVector3d v = t.row(2) - t.row(0);
  return u.cross(v).squaredNorm() > 0;
}

std::vector<RowVector3d> CommonCorners(const Corners& a, const Corners& b) {
  std::vector<RowVector3d> common;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (a.row(i) == b.row(j)) common.push_back(a.row(i));
    }
  }
  return common;
}

// p lies on the segment uv, or is u if there is no v.
bool IsOn(const ExactPoint<GridNumber>& p,
          const std::vector<RowVector3d>& corners) {
  const auto& u = corners.front();
  const auto& v = corners.back();
  GridNumber along(0);
  GridNumber square(0);
  for (int axis = 0; axis < 3; ++axis) {
    const auto d = Exact<GridNumber>(v[axis] - u[axis]);
    along += (p[axis] - Exact<GridNumber>(u[axis])) * d;
    square += d * d;
  }
  const GridNumber t = square == GridNumber(0) ? GridNumber(0) : along / square;
  if (t < GridNumber(0) || t > GridNumber(1)) return false;
  for (int axis = 0; axis < 3; ++axis) {
    const auto from = Exact<GridNumber>(u[axis]);
    const auto d = Exact<GridNumber>(v[axis] - u[axis]);
    if (p[axis] != from + t * d) return false;
  }
  return true;
}

const Corners kFlatCorners =
    CornersOf(RowVector3d(0, 0, 0), RowVector3d(4, 0, 0), RowVector3d(0, 4, 0));

}  // namespace

TEST(TrianglesIntersect, CrossingAndApart) {
  const Triangle upright = {Row(1, 1, -1), Row(1, 1, 1), Row(3, 3, 1)};
  ExpectIntersect(kFlat, upright, true);
  ExpectIntersect(kFlat, Shifted(upright, Row(0, 0, 1.5)), false);
  ExpectIntersect(kFlat, Shifted(upright, Row(5, 0, 0)), false);
}

TEST(TrianglesIntersect, TouchingCounts) {
  const double ulp = std::nextafter(1.0, 2.0) - 1;
  // A corner on the face, and one unit in the last place off.
  const Triangle above = {Row(1, 1, 0), Row(1, 2, 3), Row(2, 1, 3)};
  ExpectIntersect(kFlat, above, true);
  ExpectIntersect(kFlat, Shifted(above, Row(0, 0, 0x1p-1070)), false);
  const Triangle at_one = Shifted(kFlat, Row(0, 0, 1));
  ExpectIntersect(at_one, Shifted(above, Row(0, 0, 1)), true);
  Triangle off = Shifted(above, Row(0, 0, 1));
  off[0][2] += ulp;
  ExpectIntersect(at_one, off, false);
  // Corner on corner, corner on edge, edge across edge.
  ExpectIntersect(kFlat, {Row(0, 0, 0), Row(0, 0, 5), Row(0, 5, 5)}, true);
  ExpectIntersect(kFlat, {Row(2, 0, 0), Row(2, -1, 5), Row(3, -1, 5)}, true);
  ExpectIntersect(kFlat, {Row(2, 2, -1), Row(2, 2, 1), Row(9, 9, 0)}, true);
}

TEST(TrianglesIntersect, InOnePlane) {
  ExpectIntersect(kFlat, Shifted(kFlat, Row(1, 1, 0)), true);
  ExpectIntersect(
      kFlat, {Row(0.5, 0.5, 0), Row(1, 0.5, 0), Row(0.5, 1, 0)}, true);
  ExpectIntersect(kFlat, Shifted(kFlat, Row(4, 0, 0)), true);  // a corner
  ExpectIntersect(kFlat, Shifted(kFlat, Row(4.1, 0, 0)), false);
  ExpectIntersect(kFlat, kFlat, true);
}

TEST(TrianglesIntersect, WithoutArea) {
  const Triangle segment = {Row(1, 1, -1), Row(1, 1, 1), Row(1, 1, 0.5)};
  ExpectIntersect(kFlat, segment, true);
  ExpectIntersect(kFlat, Shifted(segment, Row(5, 0, 0)), false);
  const Triangle point = {Row(1, 1, 0), Row(1, 1, 0), Row(1, 1, 0)};
  ExpectIntersect(kFlat, point, true);
  ExpectIntersect(kFlat, Shifted(point, Row(0, 0, 1)), false);
  ExpectIntersect(segment, point, true);
  ExpectIntersect(point, point, true);
}

TEST(TrianglesIntersect, AgreesWithExactArithmetic) {
  std::mt19937 engine(11);
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    // Whole numbers make touching and flat placements common; shifts by a
    // rounding make nearly touching ones.
    const int range = i % 3 == 0 ? 3 : 6;
    const double noise = i % 2 == 0 ? 0 : 1e-16;
    Triangle a;
    Triangle b;
    for (Triangle* triangle : {&a, &b}) {
      for (Row& corner : *triangle) {
        for (int k = 0; k < 3; ++k) {
          corner[k] = static_cast<int>(engine() % range) +
                      noise * static_cast<int>(engine() % 5);
        }
      }
    }
    // The other library asks for an area.
    const auto has_area = [](const Triangle& t) {
      return (t[1] - t[0]).cross(t[2] - t[0]).norm() > 0.5;
    };
    if (!has_area(a) || !has_area(b)) continue;
    const bool expected = IntersectByCgal(a, b);
    ASSERT_EQ(Intersect(a, b), expected) << "placement " << i;
    ASSERT_EQ(Intersect(b, a), expected) << "placement " << i;
    hits += expected;
  }
  EXPECT_GT(hits, 1000);
}

TEST(TrianglesIntersect, AgreesWithLinearProgrammingOnTheGrid) {
  std::mt19937 random(1);
  int intersecting = 0;
  constexpr int kPlacements = 4000;
  for (int i = 0; i < kPlacements; ++i) {
    // The coarser grid makes three of four triangles touch in some way.
    const int cells = 1 + i % 4;
    const Corners a = RandomGridTriangle(cells, &random);
    const Corners b = RandomGridTriangle(cells, &random);
    const bool expected = !IntersectionByBruteForce<GridNumber>(a, b).empty();
    EXPECT_EQ(TrianglesIntersect(a, b), expected) << a << "\n\n" << b;
    EXPECT_EQ(TrianglesIntersect(b, a), expected) << b << "\n\n" << a;
    intersecting += expected;
  }
  EXPECT_GT(intersecting, kPlacements / 10);
  EXPECT_LT(intersecting, kPlacements * 9 / 10);
}

TEST(TrianglesIntersect, AgreesWithLinearProgrammingBesideContact) {
  std::mt19937 random(2);
  std::uniform_int_distribution<int> any(0, 5);
  int intersecting = 0;
  constexpr int kPlacements = 60;
  for (int i = 0; i < kPlacements; ++i) {
    // Touching on paper; rounding and a shift of an ulp or 1e-12 decide.
    Corners a, b;
    for (int k = 0; k < 3; ++k) {
      a.row(k) = RandomPoint(1, &random);
      b.row(k) = RandomPoint(1, &random);
    }
    const double s = 0.25 * any(random);
    const RowVector3d on_edge = (1 - s) * a.row(0) + s * a.row(1);
    b.row(0) = any(random) % 2 == 0
                   ? on_edge
                   : RowVector3d((on_edge + a.row(1) + a.row(2)) / 3);
    double& x = b(0, i % 3);
    if (i % 4 == 1) x = std::nextafter(x, 2);
    if (i % 4 == 2) x = std::nextafter(x, -2);
    if (i % 4 == 3) x += i % 8 < 4 ? 1e-12 : -1e-12;
    const bool expected = !IntersectionByBruteForce<RealNumber>(a, b).empty();
    EXPECT_EQ(TrianglesIntersect(a, b), expected) << i;
    EXPECT_EQ(TrianglesIntersect(b, a), expected) << i;
    intersecting += expected;
  }
  EXPECT_GT(intersecting, 0);
  EXPECT_LT(intersecting, kPlacements);
}

TEST(TrianglesIntersect, OrderAndScaleDoNotMatter) {
  std::mt19937 random(3);
  std::array<int, 3> order = {0, 1, 2};
  for (int i = 0; i < 500; ++i) {
    const Corners a = RandomGridTriangle(3, &random);
    const Corners b = RandomGridTriangle(3, &random);
    const bool expected = TrianglesIntersect(a, b);
    std::shuffle(order.begin(), order.end(), random);
    const Corners turned =
        CornersOf(a.row(order[0]), a.row(order[1]), a.row(order[2]));
    EXPECT_EQ(TrianglesIntersect(turned, b), expected);
    // Powers of two change no digit, even where products underflow.
    for (const double scale : {0x1p-20, 0x1p-200, 0x1p-350, 0x1p100}) {
      EXPECT_EQ(TrianglesIntersect(scale * a, scale * b), expected) << scale;
    }
  }
}

TEST(TrianglesIntersectBeyondCommon, AgreesWithLinearProgrammingOnTheGrid) {
  std::mt19937 random(4);
  std::array<int, 4> with_common = {};
  std::array<int, 4> intersecting = {};
  for (int i = 0; i < 6000; ++i) {
    const Corners a = RandomGridTriangle(2, &random);
    Corners b = RandomGridTriangle(2, &random);
    if (i % 2 == 0) b.row(i % 3) = a.row(0);
    if (i % 4 == 0) b.row((i + 1) % 3) = a.row(1);
    if (!HasArea(a) || !HasArea(b)) continue;
    const auto common = CommonCorners(a, b);
    bool expected = common.size() == 3;
    for (const auto& p : IntersectionByBruteForce<GridNumber>(a, b)) {
      expected = expected || common.empty() || !IsOn(p, common);
    }
    EXPECT_EQ(TrianglesIntersectBeyondCommon(a, b), expected) << a << "\n\n"
                                                              << b;
    ++with_common[common.size()];
    intersecting[common.size()] += expected;
  }
  for (int count = 0; count < 3; ++count) {
    EXPECT_GT(intersecting[count], 10) << count;
    EXPECT_LT(intersecting[count], with_common[count] - 10) << count;
  }
}

TEST(TrianglesIntersectBeyondCommon, Folded) {
  const RowVector3d u(0, 0, 0), v(4, 0, 0), p(0, 4, 0);
  const Corners a = CornersOf(u, v, p);
  EXPECT_TRUE(
      TrianglesIntersectBeyondCommon(a, CornersOf(v, u, RowVector3d(3, 1, 0))));
  EXPECT_FALSE(TrianglesIntersectBeyondCommon(
      a, CornersOf(v, u, RowVector3d(3, 1, 0x1p-1074))));
  EXPECT_FALSE(TrianglesIntersectBeyondCommon(
      a, CornersOf(v, u, RowVector3d(3, -1, 0))));
}

TEST(TrianglesIntersectBeyondCommon, Duplicates) {
  const Corners turned =
      CornersOf(kFlatCorners.row(2), kFlatCorners.row(0), kFlatCorners.row(1));
  EXPECT_TRUE(TrianglesIntersectBeyondCommon(kFlatCorners, kFlatCorners));
  EXPECT_TRUE(TrianglesIntersectBeyondCommon(kFlatCorners, turned));
}

TEST(TrianglesIntersectBeyondCommon, NeighboursWithoutArea) {
  const RowVector3d u(0, 0, 0), v(4, 0, 0), middle(1, 0, 0), p(0, 4, 0);
  const Corners a = CornersOf(u, v, p);
  const Corners sliver = CornersOf(u, v, middle);
  EXPECT_FALSE(TrianglesIntersectBeyondCommon(a, sliver));
  EXPECT_FALSE(TrianglesIntersectBeyondCommon(a, CornersOf(u, u, v)));
  EXPECT_FALSE(TrianglesIntersectBeyondCommon(a, CornersOf(u, u, u)));
  EXPECT_FALSE(TrianglesIntersectBeyondCommon(sliver, sliver));
  // From a corner into the inside.
  EXPECT_TRUE(
      TrianglesIntersectBeyondCommon(a, CornersOf(u, u, RowVector3d(1, 1, 0))));
}

TEST(IsOnTriangle, CornersEdgesInsideAndBeside) {
  EXPECT_TRUE(IsOnTriangle(RowVector3d(0, 0, 0), kFlatCorners));
  EXPECT_TRUE(IsOnTriangle(RowVector3d(2, 2, 0), kFlatCorners));
  EXPECT_TRUE(IsOnTriangle(RowVector3d(1, 1, 0), kFlatCorners));
  EXPECT_FALSE(IsOnTriangle(RowVector3d(1, 1, 0x1p-1074), kFlatCorners));
  EXPECT_FALSE(
      IsOnTriangle(RowVector3d(2, std::nextafter(2, 3), 0), kFlatCorners));
}

}  // namespace musclewarp
