// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_repair/soup_cleaning.h"

#include <gtest/gtest.h>

#include "mesh_repair/battered_meshes.h"
#include "musclewarp/mesh/defects.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

// Points on a line along y and one triangle of the first three.
TriangleSoup PointsAt(const std::vector<double>& places) {
  TriangleSoup soup;
  for (const double y : places) AddPoint({0, y, 0}, &soup);
  AddTriangle(0, 1, 2, &soup);
  return soup;
}

TEST(MergePoints, WithoutToleranceMergesEqualPointsOnly) {
  TriangleSoup soup = Icosphere(10, 2);
  const Triangles before = soup.triangles;
  const int num_points = static_cast<int>(soup.points.rows());
  TearOpen(3, &soup);
  const int copies = static_cast<int>(soup.points.rows()) - num_points;
  // The copies that no triangle used to share are gone from the triangles.
  const int duplicates = CountDefects(soup).duplicate_points;
  EXPECT_EQ(duplicates, copies);
  const PointMerges merges = MergePoints(0, &soup);
  EXPECT_EQ(merges.merged, duplicates);
  EXPECT_EQ(merges.longest, 0);
  EXPECT_EQ(soup.triangles, before);
  EXPECT_EQ(soup.points.rows(), num_points + copies);
}

TEST(MergePoints, BothZerosAreEqual) {
  TriangleSoup soup = PointsAt({0.0, 1, -0.0});
  EXPECT_EQ(MergePoints(0, &soup).merged, 1);
  EXPECT_EQ(soup.triangles.row(0), Eigen::RowVector3i(0, 1, 0));
}

TEST(MergePoints, ToAPointThatWasItselfKept) {
  // The second is near to both others, which are not near to each other.
  TriangleSoup soup = PointsAt({0, 0.75, 1.5});
  const PointMerges merges = MergePoints(1, &soup);
  EXPECT_EQ(merges.merged, 1);
  EXPECT_EQ(merges.longest, 0.75);
  EXPECT_EQ(soup.triangles.row(0), Eigen::RowVector3i(0, 0, 2));
}

TEST(MergePoints, ToTheFirstOfSeveral) {
  TriangleSoup soup = PointsAt({1.5, 0, 0.75});
  MergePoints(1, &soup);
  EXPECT_EQ(soup.triangles.row(0), Eigen::RowVector3i(0, 1, 0));
}

TEST(RemoveDegenerateTriangles, KeepsTheOrderOfTheOthers) {
  TriangleSoup soup = UnitTetrahedron();
  const int on_the_line = AddPoint({2, 0, 0}, &soup);
  AddTriangle(2, 2, 3, &soup);
  AddTriangle(0, 1, on_the_line, &soup);
  soup.triangles.row(0).swap(soup.triangles.row(4));
  EXPECT_EQ(RemoveDegenerateTriangles(&soup), 2);
  const Triangles all = UnitTetrahedron().triangles;
  ASSERT_EQ(soup.triangles.rows(), 4);
  EXPECT_EQ(soup.triangles.topRows(3), all.bottomRows(3));
  EXPECT_EQ(soup.triangles.row(3), all.row(0));
  EXPECT_EQ(RemoveDegenerateTriangles(&soup), 0);
}

TEST(RemoveDegenerateTriangles, AThinTriangleHasAnArea) {
  TriangleSoup soup = PointsAt({0, 1, 2});
  EXPECT_EQ(RemoveDegenerateTriangles(&soup), 1);
  soup = PointsAt({0, 1, 2});
  soup.points(1, 0) = 1e-12;
  EXPECT_EQ(RemoveDegenerateTriangles(&soup), 0);
}

TEST(RemoveDuplicateTriangles, KeepsTheFirstOfEqualCorners) {
  Triangles triangles(6, 3);
  triangles << 0, 1, 2, 3, 4, 5, 1, 2, 0, 2, 1, 0, 0, 1, 3, 3, 4, 5;
  EXPECT_EQ(RemoveDuplicateTriangles(&triangles), 3);
  Triangles expected(3, 3);
  expected << 0, 1, 2, 3, 4, 5, 0, 1, 3;
  EXPECT_EQ(triangles, expected);
}

}  // namespace
}  // namespace musclewarp
