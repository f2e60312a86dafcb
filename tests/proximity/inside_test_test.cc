// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/proximity/inside_test.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "musclewarp/cgal/exact_predicates.h"
#include "proximity/random_meshes.h"
#include "proximity/voxel_meshes.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// Strictly behind all faces of a convex mesh, exactly.
bool ConvexContains(const TriangleSoup& soup, const RowVector3d& p) {
  for (Eigen::Index f = 0; f < soup.triangles.rows(); ++f) {
    if (Orientation(soup.points.row(soup.triangles(f, 0)),
                    soup.points.row(soup.triangles(f, 1)),
                    soup.points.row(soup.triangles(f, 2)),
                    p) >= 0) {
      return false;
    }
  }
  return true;
}

TriangleSoup Transformed(TriangleSoup soup, const Eigen::Matrix3d& matrix) {
  soup.points = soup.points * matrix.transpose();
  return soup;
}

// Corners, and points that rounding puts beside or on edges and faces.
Points SpecialPoints(const TriangleSoup& soup) {
  Points special(soup.points.rows() + 2 * soup.triangles.rows(), 3);
  special.topRows(soup.points.rows()) = soup.points;
  for (Eigen::Index f = 0; f < soup.triangles.rows(); ++f) {
    const RowVector3d a = soup.points.row(soup.triangles(f, 0));
    const RowVector3d b = soup.points.row(soup.triangles(f, 1));
    const RowVector3d c = soup.points.row(soup.triangles(f, 2));
    special.row(soup.points.rows() + 2 * f) = 0.5 * (a + b);
    special.row(soup.points.rows() + 2 * f + 1) = (a + b + c) / 3;
  }
  return special;
}

Points RandomPointsAround(int count,
                          const TriangleSoup& soup,
                          std::mt19937* random) {
  const RowVector3d lower = soup.points.colwise().minCoeff();
  const RowVector3d upper = soup.points.colwise().maxCoeff();
  Points points(count, 3);
  for (int i = 0; i < count; ++i) {
    points.row(i) = lower + 0.5 * (RandomPoint(1.2, random).array() + 1)
                                      .matrix()
                                      .cwiseProduct(upper - lower);
  }
  return points;
}

void ExpectConvexAnswers(const TriangleSoup& soup, std::mt19937* random) {
  const InsideTest test(soup.points, soup.triangles, 1);
  ASSERT_TRUE(test.IsClosed());
  for (const Points& points :
       {RandomPointsAround(1000, soup, random), SpecialPoints(soup)}) {
    for (const RowVector3d p : points.rowwise()) {
      EXPECT_EQ(test.Contains(p), ConvexContains(soup, p)) << p;
    }
  }
}

}  // namespace

TEST(InsideTest, KnowsLatticeSolidsExactly) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 20; ++trial) {
    const VoxelSolid solid(4, 0.1 + 0.04 * trial, &random);
    const TriangleSoup soup = solid.Surface();
    const InsideTest test(soup.points, soup.triangles, trial);
    ASSERT_TRUE(test.IsClosed());
    // Corners, edges, faces and middles of all cubes, and outside.
    for (int i = 0; i < 10 * 10 * 10; ++i) {
      const Eigen::RowVector3i place(i % 10, i / 10 % 10, i / 100);
      const RowVector3d p = 0.5 * (place.cast<double>().array() - 1);
      EXPECT_EQ(test.Contains(p), solid.Contains(p)) << p;
    }
  }
}

TEST(InsideTest, KnowsConvexSolidsExactly) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 10; ++trial) {
    const Eigen::Matrix3d rotation =
        Eigen::Quaterniond::FromTwoVectors(RandomPoint(1, &random).transpose(),
                                           Eigen::Vector3d::UnitX())
            .toRotationMatrix();
    ExpectConvexAnswers(Transformed(Icosphere(10, 2), rotation), &random);
    ExpectConvexAnswers(Transformed(UnitTetrahedron(), rotation), &random);
  }
}

TEST(InsideTest, KnowsNeedlesAndPlates) {
  std::mt19937 random(3);
  const auto scaled = [](double x, double y, double z) {
    return Transformed(Icosphere(10, 2), Eigen::Vector3d(x, y, z).asDiagonal());
  };
  ExpectConvexAnswers(scaled(1e-4, 1e-4, 1), &random);
  ExpectConvexAnswers(scaled(1, 1, 1e-5), &random);
  ExpectConvexAnswers(Box(1, 2, 3), &random);
  ExpectConvexAnswers(Box(1e-3, 50, 200), &random);
}

TEST(InsideTest, KnowsACavityAndSeveralPieces) {
  std::mt19937 random(4);
  TriangleSoup cavity = Icosphere(4, 2);
  cavity.triangles.col(1).swap(cavity.triangles.col(2));
  const TriangleSoup ball = Icosphere(10, 2);
  const TriangleSoup other = MovedBy(Icosphere(3, 1), {20, 0, 0});
  const TriangleSoup all = Together(Together(ball, cavity), other);
  const InsideTest test(all.points, all.triangles, 1);
  cavity.triangles.col(1).swap(cavity.triangles.col(2));
  const Points points = RandomPointsAround(3000, all, &random);
  for (const RowVector3d p : points.rowwise()) {
    EXPECT_EQ(test.Contains(p),
              (ConvexContains(ball, p) && !ConvexContains(cavity, p)) ||
                  ConvexContains(other, p))
        << p;
  }
}

TEST(InsideTest, DoesNotDependOnSeedOrderOrThreads) {
  std::mt19937 random(5);
  const VoxelSolid solid(6, 0.6, &random);
  const TriangleSoup soup = solid.Surface();
  const InsideTest one(soup.points, soup.triangles, 1);
  const InsideTest two(soup.points, soup.triangles, 99);
  const Points points = RandomPointsAround(4000, soup, &random);
  std::vector<char> from_threads(points.rows());
#pragma omp parallel for schedule(dynamic, 16) num_threads(4)
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    from_threads[i] = two.Contains(points.row(i));
  }
  for (Eigen::Index i = points.rows() - 1; i >= 0; --i) {
    EXPECT_EQ(one.Contains(points.row(i)), from_threads[i] != 0);
    EXPECT_EQ(one.Contains(points.row(i)), solid.Contains(points.row(i)));
  }
}

TEST(InsideTest, AsksTheWindingNumberOfAnOpenMesh) {
  std::mt19937 random(6);
  TriangleSoup soup = Box(10, 10, 10);
  soup.triangles = soup.triangles.topRows(10).eval();  // one face is missing
  const InsideTest test(soup.points, soup.triangles, 1);
  EXPECT_FALSE(test.IsClosed());
  const SearchableMesh mesh(soup);
  int inside = 0;
  const Points points = RandomPointsAround(2000, soup, &random);
  for (const RowVector3d p : points.rowwise()) {
    EXPECT_EQ(test.Contains(p), mesh.winding().IsInside(p));
    inside += test.Contains(p);
  }
  EXPECT_GT(inside, 0);
  EXPECT_TRUE(test.Contains(soup.points.colwise().mean()));
}

TEST(InsideTest, FollowsMovedPoints) {
  std::mt19937 random(7);
  const TriangleSoup before = Icosphere(10, 2);
  const TriangleSoup after = MovedBy(before, {7, 1, -3});
  InsideTest test(before.points, before.triangles, 1);
  const Points points =
      RandomPointsAround(500, Together(before, after), &random);
  for (const RowVector3d p : points.rowwise()) test.Contains(p);
  test.Refit(after.points);
  for (const RowVector3d p : points.rowwise()) {
    EXPECT_EQ(test.Contains(p), ConvexContains(after, p));
  }
}

TEST(InsideTest, HasAnAnswerForNothing) {
  const InsideTest test(Points(0, 3), Triangles(0, 3), 1);
  EXPECT_FALSE(test.Contains({0, 0, 0}));
  EXPECT_TRUE(std::isinf(test.DistanceAlong({0, 0, 0}, {1, 0, 0})));
}

}  // namespace musclewarp
