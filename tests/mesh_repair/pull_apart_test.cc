// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_repair/pull_apart.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh_repair/battered_meshes.h"
#include "musclewarp/mesh/defects.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

// A thousandth of 1 mm, rounded.
constexpr double kPullRounding = 1e-18;

TEST(PullApart, LeavesACleanMeshAlone) {
  TriangleSoup soup = Icosphere(10, 2);
  const Points before = soup.points;
  EXPECT_EQ(PullApart(&soup).points, 0);
  EXPECT_EQ(soup.points, before);
}

TEST(PullApart, MovesTheLaterPointToItsNeighbours) {
  // Two tetrahedra with a corner at the origin each.
  TriangleSoup soup = UnitTetrahedron();
  TriangleSoup other = UnitTetrahedron();
  other.points *= -1;
  other.triangles.col(1).swap(other.triangles.col(2));
  AddSoup(other, &soup);
  ASSERT_EQ(CountDefects(soup).duplicate_points, 1);
  const Points before = soup.points;
  const Pulls pulls = PullApart(&soup);
  EXPECT_EQ(pulls.points, 1);
  EXPECT_NEAR(pulls.longest, 1e-3 / std::sqrt(3.0), kPullRounding);
  const Eigen::RowVector3d third = Eigen::RowVector3d::Constant(-1e-3 / 3);
  EXPECT_LT((soup.points.row(4) - third).norm(), kPullRounding);
  soup.points.row(4).setZero();
  EXPECT_EQ(soup.points, before);
}

TEST(PullApart, MovesAPointInTheMiddleOfItsNeighboursAlongAnEdge) {
  // A square of four triangles around the origin, where another point is.
  TriangleSoup soup;
  for (const auto& [x, y] :
       {std::pair(0, 0), {1, 0}, {0, 1}, {-1, 0}, {0, -1}, {0, 0}}) {
    AddPoint(Eigen::RowVector3d(x, y, 0), &soup);
  }
  for (int i = 0; i < 4; ++i) AddTriangle(5, 1 + i, 1 + (i + 1) % 4, &soup);
  const Pulls pulls = PullApart(&soup);
  EXPECT_EQ(pulls.points, 1);
  EXPECT_EQ(pulls.longest, 1e-3);
  EXPECT_EQ(soup.points.row(5), Eigen::RowVector3d(1e-3, 0, 0));
}

TEST(PullApart, GivesATriangleWithoutAreaANormal) {
  // The point in the middle of an edge is in two more triangles, which bend
  // away from it.
  TriangleSoup soup = Box(2, 3, 4);
  const int a = soup.triangles(0, 0);
  const int b = soup.triangles(0, 1);
  const int middle = AddTJunction(0, {0, 0, 0}, &soup);
  AddTriangle(a, b, middle, &soup);
  ASSERT_EQ(CountDefects(soup).degenerate_triangles, 1);
  const Points before = soup.points;
  EXPECT_EQ(PullApart(&soup).points, 1);
  EXPECT_EQ(CountDefects(soup).degenerate_triangles, 0);
  EXPECT_NE(soup.points.row(middle), before.row(middle));
  EXPECT_EQ(soup.points.topRows(8), before.topRows(8));
}

}  // namespace
}  // namespace musclewarp
