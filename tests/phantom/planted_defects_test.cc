// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/phantom/planted_defects.h"

#include <gtest/gtest.h>

#include "musclewarp/mesh/defects.h"
#include "musclewarp/mesh_repair/repair.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

// 642 vertices, edges of about 4 mm: room for a dozen defects.
TriangleSoup BallMesh() { return Icosphere(30, 3); }

TEST(PlantDefects, NoneLeavesTheMesh) {
  const TriangleSoup ball = BallMesh();
  const TriangleSoup soup = PlantDefects(ball, {}, 1);
  EXPECT_EQ(soup.points, ball.points);
  EXPECT_EQ(soup.triangles, ball.triangles);
}

TEST(PlantDefects, DuplicatePointsTearTheSurface) {
  PlantedDefects planted;
  planted.duplicate_points = 3;
  const MeshDefects found = CountDefects(PlantDefects(BallMesh(), planted, 1));
  EXPECT_EQ(found.duplicate_points, 3);
  // The two edges of one triangle, each seen from both sides.
  EXPECT_EQ(found.border_edges, 3 * 4);
  EXPECT_EQ(found.non_manifold_edges, 0);
}

TEST(PlantDefects, DegenerateTriangles) {
  PlantedDefects planted;
  planted.degenerate_triangles = 4;
  const TriangleSoup soup = PlantDefects(BallMesh(), planted, 1);
  EXPECT_EQ(CountDefects(soup).degenerate_triangles, 4);
  EXPECT_EQ(soup.points.rows(), BallMesh().points.rows());
}

TEST(PlantDefects, FlapsMakeNonManifoldEdges) {
  PlantedDefects planted;
  planted.flaps = 5;
  const MeshDefects found = CountDefects(PlantDefects(BallMesh(), planted, 1));
  EXPECT_EQ(found.non_manifold_edges, 5);
  EXPECT_EQ(found.border_edges, 5 * 2);
  EXPECT_EQ(found.components, 1);
}

TEST(PlantDefects, StrayPiecesAreClosedComponents) {
  PlantedDefects planted;
  planted.stray_pieces = 2;
  const MeshDefects found = CountDefects(PlantDefects(BallMesh(), planted, 1));
  EXPECT_EQ(found.components, 3);
  EXPECT_TRUE(found.is_closed_manifold);
  EXPECT_EQ(found.misoriented_edges, 0);
}

TEST(PlantDefects, MissingTrianglesAreHoles) {
  PlantedDefects planted;
  planted.missing_triangles = 2;
  const TriangleSoup soup = PlantDefects(BallMesh(), planted, 1);
  EXPECT_EQ(CountDefects(soup).border_edges, 2 * 3);
  EXPECT_EQ(soup.triangles.rows(), BallMesh().triangles.rows() - 2);
}

TEST(PlantDefects, TheSeedChoosesThePlaces) {
  PlantedDefects planted;
  planted.flaps = 2;
  const TriangleSoup one = PlantDefects(BallMesh(), planted, 1);
  EXPECT_EQ(one.points, PlantDefects(BallMesh(), planted, 1).points);
  EXPECT_NE(one.points, PlantDefects(BallMesh(), planted, 2).points);
}

TEST(PlantDefects, AllAtOnceCanBeRepaired) {
  const PlantedDefects planted = {2, 2, 2, 1, 1};
  for (uint32_t seed = 0; seed < 10; ++seed) {
    const TriangleSoup mesh = RepairMesh(
        PlantDefects(BallMesh(), planted, seed), "ball", {}, nullptr);
    EXPECT_TRUE(CountDefects(mesh).IsClean()) << "seed " << seed;
    EXPECT_EQ(mesh.points.rows(), 642) << "seed " << seed;
  }
}

}  // namespace
}  // namespace musclewarp
