// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/muscle_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "musclewarp/mesh/triangle.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

MuscleSurface SurfaceOf(const TriangleSoup& soup) {
  return MakeMuscleSurface(soup.points, soup.triangles, 1);
}

TEST(MuscleSurface, SharesTheAreaOfTheMeshAmongItsVertices) {
  const TriangleSoup soup = Spindle(12, 60, 3);
  double area = 0;
  for (Eigen::Index f = 0; f < soup.triangles.rows(); ++f) {
    area +=
        AreaVector(CornersOf(soup.points, soup.triangles.row(f))).norm() / 2;
  }
  EXPECT_NEAR(SurfaceOf(soup).areas.sum(), area, 1e-9 * area);
}

TEST(MuscleSurface, WeighsAnEdgeTheSameFromBothEnds) {
  const MuscleSurface surface = SurfaceOf(Spindle(12, 60, 2));
  std::map<std::pair<int, int>, double> weights;
  for (int v = 0; v < surface.num_vertices(); ++v) {
    for (int e = surface.first[v]; e < surface.first[v + 1]; ++e) {
      weights[{v, surface.neighbours[e]}] = surface.weights[e];
    }
  }
  // Euler: a closed surface of genus 0 has 3 (n - 2) edges.
  EXPECT_EQ(static_cast<int>(weights.size()),
            2 * 3 * (surface.num_vertices() - 2));
  for (const auto& [edge, weight] : weights) {
    EXPECT_EQ(weight, weights.at({edge.second, edge.first}));
  }
}

TEST(MuscleSurface, WeighsEquilateralTrianglesByCotangents) {
  // The faces of a regular tetrahedron; two of them at each edge.
  TriangleSoup soup = UnitTetrahedron();
  soup.points << 1, 1, 1, 1, -1, -1, -1, 1, -1, -1, -1, 1;
  const MuscleSurface surface = SurfaceOf(soup);
  for (const double weight : surface.weights) {
    // Half the sum of the cotangents of 60 degrees from both triangles.
    EXPECT_NEAR(weight, 1 / std::sqrt(3.0), 1e-12);
  }
}

TEST(MuscleSurface, BoundsTheWeightsOfNeedles) {
  TriangleSoup soup = Box(1, 1, 1000);
  MuscleSurfaceOptions options;
  options.min_edge_weight = 0.1;
  options.max_edge_weight = 2;
  const MuscleSurface surface =
      MakeMuscleSurface(soup.points, soup.triangles, 1000, options);
  for (const double weight : surface.weights) {
    EXPECT_GE(weight, 0.1);
    EXPECT_LE(weight, 2);
  }
}

TEST(MuscleSurface, HasNoExemptTrianglesUnlessToldSo) {
  MuscleSurface surface = SurfaceOf(UnitTetrahedron());
  EXPECT_FALSE(surface.IsExempt(0, 0));
  surface.exempt = {{}, {0, 1, 0, 0}};
  EXPECT_FALSE(surface.IsExempt(0, 1));
  EXPECT_TRUE(surface.IsExempt(1, 1));
  EXPECT_FALSE(surface.IsExempt(1, 2));
}

TEST(MuscleSurfaceOptions, NameWhatIsWrong) {
  MuscleSurfaceOptions options;
  std::string error;
  EXPECT_TRUE(options.IsValid(&error));
  options.max_edge_weight = 0.001;
  EXPECT_FALSE(options.IsValid(&error));
  EXPECT_EQ(error,
            "MuscleSurfaceOptions::max_edge_weight is 0.001, allowed: 0.01 or "
            "above");
}

}  // namespace
}  // namespace musclewarp
