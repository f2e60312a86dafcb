// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh/mesh.h"

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace musclewarp {

TEST(Mesh, RoundTripKeepsOrder) {
  const TriangleSoup soup = Icosphere(10, 2);
  const TriangleSoup back = SoupFromMesh(MeshFromSoup(soup));
  EXPECT_EQ(back.points, soup.points);
  EXPECT_EQ(back.triangles, soup.triangles);
}

TEST(MeshDeathTest, ANonManifoldSoupIsAProgrammerError) {
  TriangleSoup soup = UnitTetrahedron();
  soup.triangles.row(3) = soup.triangles.row(2).eval();
  EXPECT_DEATH(MeshFromSoup(soup), "not manifold");
}

}  // namespace musclewarp
