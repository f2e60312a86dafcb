// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/studies/mesh_density.h"

#include <gtest/gtest.h>

#include "musclewarp/mesh/defects.h"
#include "musclewarp/mesh/measures.h"
#include "support/meshes.h"

namespace musclewarp {

TEST(MeshDensity, MidpointsKeepTheSurface) {
  const TriangleSoup mesh = Spindle(12, 60, 2);
  const TriangleSoup refined = MidpointRefined(mesh);
  EXPECT_EQ(refined.triangles.rows(), 4 * mesh.triangles.rows());
  // A closed surface has 3 / 2 edges a triangle.
  EXPECT_EQ(refined.points.rows(),
            mesh.points.rows() + mesh.triangles.rows() * 3 / 2);
  EXPECT_EQ(refined.points.topRows(mesh.points.rows()), mesh.points);
  EXPECT_TRUE(CountDefects(refined).is_closed_manifold);
  const double volume = SignedVolume(mesh.points, mesh.triangles);
  EXPECT_NEAR(
      SignedVolume(refined.points, refined.triangles), volume, 1e-12 * volume);
  const double area = SurfaceArea(mesh.points, mesh.triangles);
  EXPECT_NEAR(
      SurfaceArea(refined.points, refined.triangles), area, 1e-12 * area);
}

TEST(MeshDensity, DensityIsTheRatioOfTriangles) {
  const TriangleSoup mesh = Spindle(12, 60, 3);
  const double volume = SignedVolume(mesh.points, mesh.triangles);
  for (const double density : {0.25, 1., 4., 16.}) {
    ASSERT_TRUE(IsDensity(density));
    const TriangleSoup other = WithDensity(mesh, density);
    EXPECT_NEAR(static_cast<double>(other.triangles.rows()) /
                    static_cast<double>(mesh.triangles.rows()),
                density,
                0.01 * density);
    EXPECT_TRUE(CountDefects(other).is_closed_manifold) << density;
    // A quarter of the triangles cuts off some of a curved surface.
    EXPECT_NEAR(SignedVolume(other.points, other.triangles),
                volume,
                (density < 1 ? 0.05 : 1e-12) * volume);
  }
  for (const double density : {0., -1., 0.5, 2., 64.}) {
    EXPECT_FALSE(IsDensity(density)) << density;
  }
}

}  // namespace musclewarp
