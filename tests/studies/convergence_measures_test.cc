// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/studies/convergence_measures.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "musclewarp/mesh/triangle.h"
#include "musclewarp/studies/mesh_density.h"
#include "support/meshes.h"

namespace musclewarp {

TEST(ConvergenceMeasures, VerticesThatAreTheSameAreFound) {
  const TriangleSoup base = Spindle(12, 60, 2);
  for (const TriangleSoup& surface : {base, MidpointRefined(base)}) {
    const SurfacePlaces places = NearestPlaces(surface, base);
    EXPECT_LT(places.largest_distance, 1e-12);
    const Points moved =
        RandomPoints(static_cast<int>(surface.points.rows()), 7);
    const Points found = CarriedPoints(places, surface.triangles, moved);
    EXPECT_LT((found - moved.topRows(base.points.rows())).cwiseAbs().maxCoeff(),
              1e-9);
  }
}

TEST(ConvergenceMeasures, FlatTrianglesCarryPointsLinearly) {
  const TriangleSoup box = LatticeBox(4, 3, 2);
  const auto moved = [](const Points& points) -> Points {
    return (2 * points).rowwise() + Eigen::RowVector3d(1, 2, 3);
  };
  const TriangleSoup finer = MidpointRefined(box);
  const Points found = CarriedPoints(
      NearestPlaces(box, finer), box.triangles, moved(box.points));
  EXPECT_LT((found - moved(finer.points)).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(ConvergenceMeasures, RigidMovesAreExactOffTheSurface) {
  const TriangleSoup base = Spindle(12, 60, 3);
  const TriangleSoup coarse = WithDensity(base, 0.25);
  const SurfacePlaces places = NearestPlaces(coarse, base);
  EXPECT_GT(places.largest_distance, 0.1);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.8, Eigen::Vector3d(1, 2, 3).normalized())
          .toRotationMatrix();
  const Points found =
      CarriedPoints(places, coarse.triangles, coarse.points * turn);
  EXPECT_LT((found - base.points * turn).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(ConvergenceMeasures, PlacesAreOnTheSideThatFacesTheSameWay) {
  // The upper side of a sheet, moved below its lower side.
  const TriangleSoup sheet = LatticeBox(8, 8, 1);
  const TriangleSoup lower = MovedBy(sheet, {0, 0, -0.9});
  const SurfacePlaces places = NearestPlaces(sheet, lower);
  ASSERT_EQ(places.barycentric.rows(), lower.points.rows());
  for (Eigen::Index v = 0; v < lower.points.rows(); ++v) {
    const Eigen::RowVector3d p = sheet.points.row(v);
    const bool is_inner = p[0] > 0 && p[0] < 8 && p[1] > 0 && p[1] < 8;
    if (!is_inner) continue;
    const Corners corners =
        CornersOf(sheet.points, sheet.triangles.row(places.triangles[v]));
    EXPECT_NEAR((places.barycentric.row(v) * corners)[2], p[2], 1e-12) << p;
  }
}

}  // namespace musclewarp
