// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/cgal/cgal_mesh.h"

#include <CGAL/boost/graph/Euler_operations.h>
#include <gtest/gtest.h>

#include "musclewarp/mesh/defects.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

// True if two triangles have the same corners in the same direction of turning.
bool IsSameTriangle(const Eigen::RowVector3i& a, const Eigen::RowVector3i& b) {
  return a == b || a == Eigen::RowVector3i(b[1], b[2], b[0]) ||
         a == Eigen::RowVector3i(b[2], b[0], b[1]);
}

}  // namespace

TEST(CgalMesh, ThereAndBackIsTheSameMesh) {
  for (const TriangleSoup& soup :
       {Icosphere(3, 3), UnitTetrahedron(), LatticeBox(2, 3, 4)}) {
    const TriangleSoup back = FromCgalMesh(ToCgalMesh(soup));
    EXPECT_EQ(back.points, soup.points);
    ASSERT_EQ(back.triangles.rows(), soup.triangles.rows());
    for (Eigen::Index f = 0; f < soup.triangles.rows(); ++f) {
      EXPECT_TRUE(IsSameTriangle(back.triangles.row(f), soup.triangles.row(f)))
          << f;
    }
  }
}

TEST(CgalMesh, ComesBackWithoutRemovedElements) {
  const TriangleSoup ball = Icosphere(3, 2);
  CgalMesh mesh = ToCgalMesh(ball);
  const CgalMesh::Halfedge_index edge = *mesh.halfedges().begin();
  CGAL::Euler::collapse_edge(mesh.edge(edge), mesh);
  const TriangleSoup back = FromCgalMesh(mesh);
  EXPECT_EQ(back.points.rows(), ball.points.rows() - 1);
  EXPECT_EQ(back.triangles.rows(), ball.triangles.rows() - 2);
  EXPECT_TRUE(CountDefects(back).IsClean());
}

TEST(CgalMeshDeathTest, RefusesEdgesOfThreeTriangles) {
  TriangleSoup soup = UnitTetrahedron();
  soup.points.conservativeResize(5, 3);
  soup.points.row(4) << 1, 1, 1;
  soup.triangles.conservativeResize(5, 3);
  soup.triangles.row(4) << 0, 1, 4;
  EXPECT_DEATH(ToCgalMesh(soup), "not a manifold");
}

}  // namespace musclewarp
