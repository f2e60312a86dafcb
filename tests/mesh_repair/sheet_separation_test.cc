// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_repair/sheet_separation.h"

#include <gtest/gtest.h>

#include "mesh_repair/battered_meshes.h"
#include "musclewarp/mesh/defects.h"
#include "musclewarp/mesh/measures.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

// Sums of eight terms of size one.
constexpr double kSheetRounding = 1e-15;

// Appends the tetrahedron turned by 180 degrees about the x axis, with the
// corners at (0, 0, 0) and (1, 0, 0) in common if `shared` is 2, or only the
// first if it is 1.
TriangleSoup TwoTetrahedra(int shared) {
  TriangleSoup soup = UnitTetrahedron();
  const TriangleSoup one = soup;
  std::vector<int> index = {0, 1, 2, 3};
  for (int v = shared; v < 4; ++v) {
    Eigen::RowVector3d p = one.points.row(v);
    // One corner in common: turned about z, so that x points away.
    p = shared == 2 ? Eigen::RowVector3d(p.x(), -p.y(), -p.z())
                    : Eigen::RowVector3d(-p.x(), -p.y(), p.z() + 2 * (v == 3));
    index[v] = AddPoint(p, &soup);
  }
  for (int f = 0; f < 4; ++f) {
    AddTriangle(index[one.triangles(f, 0)],
                index[one.triangles(f, 1)],
                index[one.triangles(f, 2)],
                &soup);
  }
  return soup;
}

TEST(SeparateAtNonManifoldEdges, LeavesAManifoldAlone) {
  TriangleSoup soup = Icosphere(10, 2);
  const TriangleSoup before = soup;
  const Separation separation = SeparateAtNonManifoldEdges(&soup);
  EXPECT_EQ(separation.edges, 0);
  EXPECT_EQ(separation.copies, 0);
  EXPECT_EQ(soup.points, before.points);
  EXPECT_EQ(soup.triangles, before.triangles);
}

TEST(SeparateAtNonManifoldEdges, TwoBodiesWithACommonEdgeBecomeTwo) {
  TriangleSoup soup = TwoTetrahedra(2);
  ASSERT_EQ(CountDefects(soup).non_manifold_edges, 1);
  const Points before = soup.points;
  const Separation separation = SeparateAtNonManifoldEdges(&soup);
  EXPECT_EQ(separation.edges, 1);
  EXPECT_EQ(separation.copies, 2);
  const MeshDefects defects = CountDefects(soup);
  EXPECT_TRUE(defects.is_closed_manifold);
  EXPECT_EQ(defects.components, 2);
  EXPECT_EQ(defects.misoriented_edges, 0);
  // Copies lie on their originals.
  EXPECT_EQ(defects.duplicate_points, 2);
  EXPECT_EQ(soup.points.topRows(6), before);
  EXPECT_NEAR(
      SignedVolume(soup.points, soup.triangles), 2.0 / 6, kSheetRounding);
}

TEST(SeparateAtNonManifoldEdges, AFlapEndsInABorder) {
  TriangleSoup soup = UnitTetrahedron();
  const int tip = AddPoint({0.5, -1, -1}, &soup);
  AddTriangle(0, 1, tip, &soup);
  const Separation separation = SeparateAtNonManifoldEdges(&soup);
  EXPECT_EQ(separation.edges, 1);
  EXPECT_EQ(separation.copies, 2);
  const MeshDefects defects = CountDefects(soup);
  EXPECT_EQ(defects.border_edges, 3);
  EXPECT_EQ(defects.components, 2);
  // The body keeps its points.
  EXPECT_EQ(soup.triangles.topRows(4), UnitTetrahedron().triangles);
}

TEST(SeparateAtNonManifoldVertices, TwoBodiesWithACommonPointBecomeTwo) {
  TriangleSoup soup = TwoTetrahedra(1);
  ASSERT_EQ(CountDefects(soup).non_manifold_vertices, 1);
  ASSERT_EQ(CountDefects(soup).non_manifold_edges, 0);
  const Points before = soup.points;
  EXPECT_EQ(SeparateAtNonManifoldVertices(&soup), 1);
  const MeshDefects defects = CountDefects(soup);
  EXPECT_TRUE(defects.is_closed_manifold);
  EXPECT_EQ(defects.components, 2);
  EXPECT_EQ(soup.points.topRows(7), before);
  EXPECT_EQ(soup.points.row(7), before.row(0));
}

TEST(SeparateAtNonManifoldVertices, TheWidestFanKeepsThePoint) {
  // The tetrahedron comes first, but has three triangles at the point; the
  // ball has five.
  TriangleSoup soup = UnitTetrahedron();
  const TriangleSoup ball = Icosphere(10, 1);
  const int offset = static_cast<int>(soup.points.rows());
  AddSoup(MovedBy(ball, -ball.points.row(0)), &soup);
  for (int& corner : soup.triangles.reshaped()) {
    if (corner == 0) corner = offset;
  }
  const Triangles before = soup.triangles;
  EXPECT_EQ(SeparateAtNonManifoldVertices(&soup), 1);
  EXPECT_EQ(soup.triangles.bottomRows(80), before.bottomRows(80));
  EXPECT_EQ((soup.triangles.topRows(4).array() == offset + 42).count(), 3);
}

TEST(SeparateAtNonManifoldVertices, LeavesAManifoldAlone) {
  TriangleSoup soup = Icosphere(10, 2);
  CutOff(6, &soup);
  const Triangles before = soup.triangles;
  EXPECT_EQ(SeparateAtNonManifoldVertices(&soup), 0);
  EXPECT_EQ(soup.triangles, before);
}

}  // namespace
}  // namespace musclewarp
