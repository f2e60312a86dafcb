// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/triangle_intersection.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangle_3.h>
#include <CGAL/intersections.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <random>

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

}  // namespace musclewarp
