// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/convergence_measures.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/meshes.h"
#include "tools/mesh_density.h"

namespace musclewarp {

TEST(ConvergenceMeasures, AFieldIsFoundAtTheSameVertices) {
  const TriangleSoup base = Spindle(12, 60, 2);
  for (const TriangleSoup& surface : {base, MidpointRefined(base)}) {
    const SurfacePlaces places = NearestPlaces(surface, base);
    EXPECT_LT(places.largest_distance, 1e-12);
    const Points field =
        RandomPoints(static_cast<int>(surface.points.rows()), 7);
    const Points found = FieldAt(places, surface.triangles, field);
    EXPECT_LT((found - field.topRows(base.points.rows())).cwiseAbs().maxCoeff(),
              1e-9);
  }
}

TEST(ConvergenceMeasures, ALinearFieldIsFoundExactlyWhereSurfacesAreFlat) {
  const TriangleSoup box = LatticeBox(4, 3, 2);
  const auto field = [](const Points& points) -> Points {
    return (2 * points).rowwise() + Eigen::RowVector3d(1, 2, 3);
  };
  const TriangleSoup finer = MidpointRefined(box);
  const Points found =
      FieldAt(NearestPlaces(box, finer), box.triangles, field(box.points));
  EXPECT_LT((found - field(finer.points)).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(ConvergenceMeasures, PlacesAreOnTheSideThatFacesTheSameWay) {
  // The upper side of a sheet, moved below its lower side.
  const TriangleSoup sheet = LatticeBox(8, 8, 1);
  const TriangleSoup lower = MovedBy(sheet, {0, 0, -0.9});
  const SurfacePlaces places = NearestPlaces(sheet, lower);
  const Points found = FieldAt(places, sheet.triangles, sheet.points);
  for (Eigen::Index v = 0; v < lower.points.rows(); ++v) {
    const Eigen::RowVector3d p = sheet.points.row(v);
    const bool is_inner = p[0] > 0 && p[0] < 8 && p[1] > 0 && p[1] < 8;
    if (!is_inner) continue;
    EXPECT_NEAR(found(v, 2), p[2], 1e-12) << p;
  }
}

TEST(ConvergenceMeasures, QuantilesCountWeights) {
  const Eigen::Vector3d values(3, 1, 2), weights(1, 98, 1);
  EXPECT_EQ(WeightedQuantile(values, weights, 0.5), 1);
  EXPECT_EQ(WeightedQuantile(values, weights, 0.985), 2);
  EXPECT_EQ(WeightedQuantile(values, weights, 1), 3);
}

TEST(ConvergenceMeasures, EvenStretchIsTheSameEverywhere) {
  const TriangleSoup sphere = Icosphere(10, 3);
  const StretchSummary stretch =
      SummariseStretch(sphere, (1.5 * sphere.points).eval());
  EXPECT_NEAR(stretch.mean, 1.5, 1e-9);
  EXPECT_NEAR(stretch.percentile_99, 1.5, 1e-9);
  EXPECT_NEAR(stretch.percentile_999, 1.5, 1e-9);
  EXPECT_NEAR(stretch.largest, 1.5, 1e-9);
}

}  // namespace musclewarp
