// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh/defects.h"

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace musclewarp {
namespace {

void AddTriangle(int a, int b, int c, TriangleSoup* soup) {
  soup->triangles.conservativeResize(soup->triangles.rows() + 1, 3);
  soup->triangles.bottomRows<1>() << a, b, c;
}

void AddPoint(double x, double y, double z, TriangleSoup* soup) {
  soup->points.conservativeResize(soup->points.rows() + 1, 3);
  soup->points.bottomRows<1>() << x, y, z;
}

TEST(Defects, ASphereHasNone) {
  const MeshDefects defects = CountDefects(Icosphere(10, 2));
  EXPECT_TRUE(defects.IsClean());
  EXPECT_TRUE(defects.is_closed_manifold);
  EXPECT_EQ(defects.components, 1);
}

TEST(Defects, NothingIsNotClean) {
  EXPECT_FALSE(CountDefects(TriangleSoup()).IsClean());
}

TEST(Defects, DuplicateAndUnreferencedPoints) {
  TriangleSoup soup = UnitTetrahedron();
  AddPoint(1, 0, 0, &soup);
  AddPoint(7, 7, 7, &soup);
  const MeshDefects defects = CountDefects(soup);
  EXPECT_EQ(defects.duplicate_points, 1);
  EXPECT_EQ(defects.unreferenced_points, 2);
  EXPECT_TRUE(defects.is_closed_manifold);
  EXPECT_FALSE(defects.IsClean());
}

TEST(Defects, DegenerateTriangles) {
  TriangleSoup soup = UnitTetrahedron();
  AddPoint(2, 0, 0, &soup);
  AddTriangle(0, 1, 4, &soup);  // On a line.
  AddTriangle(2, 2, 3, &soup);
  EXPECT_EQ(CountDefects(soup).degenerate_triangles, 2);
}

TEST(Defects, DuplicateTrianglesMakeNonManifoldEdges) {
  TriangleSoup soup = UnitTetrahedron();
  AddTriangle(2, 0, 1, &soup);
  const MeshDefects defects = CountDefects(soup);
  EXPECT_EQ(defects.duplicate_triangles, 1);
  EXPECT_EQ(defects.non_manifold_edges, 3);
  EXPECT_FALSE(defects.is_closed_manifold);
}

TEST(Defects, AMissingTriangleLeavesItsThreeEdges) {
  TriangleSoup soup = UnitTetrahedron();
  soup.triangles.conservativeResize(3, 3);  // Without the slanted one.
  const MeshDefects defects = CountDefects(soup);
  EXPECT_EQ(defects.border_edges, 3);
  EXPECT_DOUBLE_EQ(defects.border_length, 3 * std::sqrt(2.0));
  EXPECT_FALSE(defects.is_closed_manifold);
}

TEST(Defects, TwoTetrahedraThatShareAPoint) {
  TriangleSoup soup = UnitTetrahedron();
  AddPoint(-1, 0, 0, &soup);
  AddPoint(0, -1, 0, &soup);
  AddPoint(0, 0, -1, &soup);
  AddTriangle(0, 4, 5, &soup);
  AddTriangle(0, 5, 6, &soup);
  AddTriangle(0, 6, 4, &soup);
  AddTriangle(4, 6, 5, &soup);
  const MeshDefects defects = CountDefects(soup);
  EXPECT_EQ(defects.non_manifold_vertices, 1);
  EXPECT_EQ(defects.non_manifold_edges, 0);
  EXPECT_EQ(defects.components, 2);
  EXPECT_FALSE(defects.is_closed_manifold);
}

TEST(Defects, ATurnedTriangleContradictsItsNeighbours) {
  TriangleSoup soup = UnitTetrahedron();
  soup.triangles.row(1).reverseInPlace();
  const MeshDefects defects = CountDefects(soup);
  EXPECT_EQ(defects.misoriented_edges, 3);
  EXPECT_TRUE(defects.is_closed_manifold);
  EXPECT_FALSE(defects.IsClean());
}

TEST(Defects, InsideOut) {
  TriangleSoup soup = UnitTetrahedron();
  soup.triangles.col(0).swap(soup.triangles.col(1));
  EXPECT_TRUE(CountDefects(soup).is_inside_out);
  EXPECT_FALSE(CountDefects(soup).IsClean());
}

}  // namespace
}  // namespace musclewarp
