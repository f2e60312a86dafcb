// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/surface_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "musclewarp/mesh/measures.h"
#include "musclewarp/phantom/field.h"
#include "musclewarp/phantom/polygonize.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

// Every triangle with points of its own, and about a third of them the wrong
// way round, in no order.
TriangleSoup TornApart(const TriangleSoup& whole) {
  std::mt19937 random(1);
  TriangleSoup torn;
  const int count = whole.triangles.rows();
  torn.points.resize(3 * count, 3);
  torn.triangles.resize(count, 3);
  for (int f = 0; f < count; ++f) {
    for (int c = 0; c < 3; ++c) {
      torn.points.row(3 * f + c) = whole.points.row(whole.triangles(f, c));
      torn.triangles(f, c) = 3 * f + c;
    }
    if (random() % 3 == 0)
      std::swap(torn.triangles(f, 1), torn.triangles(f, 2));
  }
  return torn;
}

double LargestGapFrom(const Points& from, const Points& to) {
  double largest = 0;
  for (const auto& point : from.rowwise()) {
    largest =
        std::max(largest, (to.rowwise() - point).rowwise().norm().minCoeff());
  }
  return largest;
}

TEST(SurfacePoints, AreAsManyAsTheAreaHasSquaresOfTheSpacing) {
  const TriangleSoup sphere = Icosphere(20, 3);
  const double area = SurfaceArea(sphere.points, sphere.triangles);
  for (const double spacing : {1.2, 2.0, 3.7}) {
    SurfaceSampling sampling;
    sampling.spacing = spacing;
    const SurfacePoints points = SampleSurface(sphere, sampling);
    EXPECT_EQ(points.size(), std::ceil(area / (spacing * spacing)));
    EXPECT_EQ(points.normals.rows(), points.size());
    // Each stands for the same part of the area; 1e-9 is for rounding.
    EXPECT_NEAR(points.area * points.size(), area, 1e-9 * area);
  }
}

TEST(SurfacePoints, AreSpreadByAreaWhateverTheTriangles) {
  // Sides of two triangles each, and sides of many.
  const TriangleSoup plain = MovedBy(Box(10, 20, 30), {5, 10, 15});
  const TriangleSoup fine = LatticeBox(10, 20, 30);
  for (const TriangleSoup* box : {&plain, &fine}) {
    const SurfacePoints points = SampleSurface(*box);
    int on_side = 0, on_lower_half = 0;
    for (const auto& point : points.points.rowwise()) {
      on_side += point.x() < 1e-9;
      on_lower_half += point.z() < 15;
    }
    // Of a run of triangles at most one point is counted more or less at each
    // end. Half a side of two triangles is a part of both, whose points are
    // spread evenly to a few.
    constexpr double kEnds = 2, kHalves = 12;
    EXPECT_NEAR(on_side, 20 * 30 / points.area, kEnds);
    EXPECT_NEAR(on_lower_half, points.size() / 2.0, kHalves);
  }
}

TEST(SurfacePoints, HaveNoLargeGapsAndNoClusters) {
  const SurfacePoints points = SampleSurface(Icosphere(20, 1));
  const Points everywhere = SampleSurface(Icosphere(20, 1), {0.5}).points;
  // No place is farther from a point than two spacings.
  EXPECT_LT(LargestGapFrom(everywhere, points.points), 2 * 1.2);
}

TEST(SurfacePoints, HaveRadialNormalsOnASphere) {
  constexpr double kRadius = 20;
  const SurfacePoints points = SampleSurface(Icosphere(kRadius, 3));
  double sum = 0;
  for (int i = 0; i < points.size(); ++i) {
    const Eigen::RowVector3d normal = points.normals.row(i);
    EXPECT_NEAR(normal.norm(), 1, 1e-12);
    const double angle =
        std::acos(std::min(1.0, normal.dot(points.points.row(i).normalized())));
    // The edges are 3 mm long: at a corner, 1.8 mm from the middle of its
    // triangle, the normal of the triangle is 1.8 / 20 = 0.09 off the radius.
    EXPECT_LT(angle, 0.09);
    sum += angle * angle;
  }
  // That of the triangle is 0.05 off in the root mean square; the mean around a
  // point is better.
  EXPECT_LT(std::sqrt(sum / points.size()), 0.035);
}

TEST(SurfacePoints, AreTheSameIfTrianglesAreTornApartAndTurned) {
  const TriangleSoup whole = Icosphere(20, 3);
  const SurfacePoints expected = SampleSurface(whole);
  const SurfacePoints torn = SampleSurface(TornApart(whole));
  ASSERT_EQ(torn.size(), expected.size());
  for (int i = 0; i < torn.size(); ++i) {
    EXPECT_GT(torn.normals.row(i).dot(torn.points.row(i)), 0);
  }
  // Points within a triangle may have changed places, by less than its size.
  EXPECT_LT(LargestGapFrom(torn.points, expected.points), 1.8);
  EXPECT_LT(LargestGapFrom(expected.points, torn.points), 1.8);
}

TEST(SurfacePoints, HaveOutwardNormalsOnASurfaceWithAHole) {
  TriangleSoup open = Icosphere(20, 3);
  open.triangles =
      open.triangles.topRows(open.triangles.rows() * 9 / 10).eval();
  const SurfacePoints points = SampleSurface(open);
  EXPECT_GT(points.size(), 2000);
  for (int i = 0; i < points.size(); ++i) {
    EXPECT_GT(points.normals.row(i).dot(points.points.row(i)), 0);
  }
}

TEST(SurfacePoints, LeaveOutAnInnerWall) {
  const TriangleSoup outer = Icosphere(20, 3), inner = Icosphere(16, 3);
  TriangleSoup inward = inner;
  inward.triangles.col(1).swap(inward.triangles.col(2));
  const int expected = SampleSurface(outer).size();
  for (const TriangleSoup& both : {Together(outer, inner),
                                   Together(inner, outer),
                                   Together(outer, inward)}) {
    const SurfacePoints points = SampleSurface(both);
    EXPECT_EQ(points.size(), expected);
    for (int i = 0; i < points.size(); ++i) {
      EXPECT_GT(points.points.row(i).norm(), 19);
      EXPECT_GT(points.normals.row(i).dot(points.points.row(i)), 0);
    }
  }
}

TEST(SurfacePoints, LieOnEachOfTwoBodiesSideBySide) {
  const TriangleSoup first = Icosphere(20, 3);
  const TriangleSoup second = SphereAt({45, 0, 0}, 18, 3);
  const SurfacePoints points = SampleSurface(Together(first, second));
  int on_second = 0;
  for (const auto& point : points.points.rowwise()) on_second += point.x() > 22;
  // Where one body ends and the other begins a point may be on either.
  EXPECT_NEAR(on_second, SampleSurface(second).size(), 1);
  EXPECT_NEAR(points.size() - on_second, SampleSurface(first).size(), 1);
}

TEST(SurfacePoints, LieOnABallInTheHoleOfARing) {
  // The box of the ring holds the ball, the ring does not.
  const phantom::Field ring_field = [](const Eigen::Vector3d& p) {
    return std::hypot(std::hypot(p.x(), p.y()) - 20, p.z()) - 8;
  };
  const Eigen::AlignedBox3d box(Eigen::Vector3d(-32, -32, -12),
                                Eigen::Vector3d(32, 32, 12));
  const TriangleSoup ring = phantom::PolygonizeField(ring_field, box, {});
  const TriangleSoup ball = Icosphere(7, 3);
  const SurfacePoints points = SampleSurface(Together(ring, ball));
  const int on_ball = (points.points.rowwise().norm().array() < 8).count();
  // Where one ends and the other begins a point may be on either.
  EXPECT_NEAR(on_ball, SampleSurface(ball).size(), 1);
  EXPECT_NEAR(points.size() - on_ball, SampleSurface(ring).size(), 1);
}

TEST(SurfacePoints, LeaveOutStrayPiecesOfLessThanOnePercent) {
  const TriangleSoup body = Icosphere(20, 3);
  // Areas are as squares of radii: 0.9 % of the whole, and 1.1 %.
  const double lesser = 20 * std::sqrt(0.009 / 0.991);
  const double larger = 20 * std::sqrt(0.011 / 0.989);
  const int alone = SampleSurface(body).size();
  EXPECT_EQ(
      SampleSurface(Together(body, SphereAt({60, 0, 0}, lesser, 3))).size(),
      alone);
  EXPECT_GT(
      SampleSurface(Together(body, SphereAt({60, 0, 0}, larger, 3))).size(),
      alone + 10);
}

TEST(SurfacePoints, AreNoneOnASurfaceWithoutArea) {
  EXPECT_EQ(SampleSurface({}).size(), 0);
  TriangleSoup needle = UnitTetrahedron();
  needle.points.rightCols<2>().setZero();
  EXPECT_EQ(SampleSurface(needle).size(), 0);
  needle.triangles.resize(0, 3);
  EXPECT_EQ(SampleSurface(needle).size(), 0);
}

TEST(SurfacePoints, AreKeptInTheOrderOfRows) {
  const SurfacePoints all = SampleSurface(Icosphere(5, 2));
  const SurfacePoints some = Subset(all, {7, 2, 7});
  ASSERT_EQ(some.size(), 3);
  EXPECT_EQ(some.points.row(0), all.points.row(7));
  EXPECT_EQ(some.normals.row(1), all.normals.row(2));
  EXPECT_EQ(some.points.row(2), all.points.row(7));
  EXPECT_EQ(some.area, all.area);
  const SurfacePoints upper =
      Filtered(all, [&](int row) { return all.points(row, 2) > 0; });
  EXPECT_EQ(upper.size(), (all.points.col(2).array() > 0).count());
  EXPECT_GT(upper.points.col(2).minCoeff(), 0);
}

}  // namespace
}  // namespace musclewarp
