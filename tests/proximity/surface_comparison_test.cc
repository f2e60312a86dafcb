// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/proximity/surface_comparison.h"

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace musclewarp {
namespace {

TriangleSoup Moved(TriangleSoup mesh, const Eigen::RowVector3d& by) {
  mesh.points.rowwise() += by;
  return mesh;
}

TEST(CompareSurfaces, AMeshIsAtNoDistanceFromItself) {
  const TriangleSoup mesh = Spindle(10, 30, 2);
  const SurfaceComparison same = CompareSurfaces(mesh, mesh, {});
  // Centres of parts of a triangle are on it up to rounding.
  EXPECT_LT(same.symmetric.largest, 1e-12);
  EXPECT_EQ(same.dice, 1);
  EXPECT_EQ(same.jaccard, 1);
  EXPECT_EQ(same.volume_a, same.volume_b);
  EXPECT_LT(same.vertex_distances.cwiseAbs().maxCoeff(), 1e-12);
}

TEST(CompareSurfaces, ConcentricSpheresAreTheDifferenceOfTheirRadiiApart) {
  const TriangleSoup inner = Icosphere(9, 4), outer = Icosphere(10, 4);
  const SurfaceComparison found = CompareSurfaces(inner, outer, {});
  // The spheres are inscribed with edges of 0.7 mm, which cut off 0.007 mm.
  constexpr double kCut = 0.01;
  EXPECT_NEAR(found.a_to_b.mean, 1, kCut);
  EXPECT_NEAR(found.a_to_b.largest, 1, kCut);
  EXPECT_NEAR(found.a_to_b.percentile_95, 1, kCut);
  EXPECT_NEAR(found.a_to_b.root_mean_square, 1, kCut);
  EXPECT_NEAR(found.a_to_b.signed_mean, -1, kCut);
  EXPECT_NEAR(found.b_to_a.signed_mean, 1, kCut);
  EXPECT_NEAR(found.vertex_distances.maxCoeff(), -1, kCut);
  // The inner one is all of the overlap.
  EXPECT_NEAR(found.jaccard, found.volume_a / found.volume_b, 0.01);
}

TEST(CompareSurfaces, TheOverlapOfShiftedBoxesIsKnown) {
  const TriangleSoup box = Box(40, 20, 10);
  const TriangleSoup shifted = Moved(box, {10, 0, 0});
  const SurfaceComparison found = CompareSurfaces(box, shifted, {});
  // 30 of 40 mm are shared, and 30 of 50 are the union's. A cell of the grid is
  // 0.43 mm, which moves each of the four ends by half as much at most.
  EXPECT_NEAR(found.dice, 0.75, 0.02);
  EXPECT_NEAR(found.jaccard, 0.6, 0.02);
  EXPECT_LE(found.symmetric.largest, 10);
  EXPECT_GT(found.symmetric.largest, 10 - found.spacing);
}

TEST(CompareSurfaces, TheOrderDoesNotMatter) {
  const TriangleSoup a = Spindle(10, 30, 2);
  const TriangleSoup b = Moved(Box(15, 25, 40), {-5, -10, -20});
  const SurfaceComparison one = CompareSurfaces(a, b, {});
  const SurfaceComparison other = CompareSurfaces(b, a, {});
  EXPECT_EQ(one.a_to_b.mean, other.b_to_a.mean);
  EXPECT_EQ(one.symmetric.largest, other.symmetric.largest);
  // Sums of tens of thousands of terms in another order.
  EXPECT_NEAR(one.symmetric.mean, other.symmetric.mean, 1e-10);
  EXPECT_EQ(one.dice, other.dice);
}

TEST(CompareSurfaces, MeshesFarApartShareNothing) {
  const TriangleSoup a = Box(10, 10, 10);
  const SurfaceComparison found = CompareSurfaces(a, Moved(a, {1e4, 0, 0}), {});
  EXPECT_EQ(found.dice, 0);
  EXPECT_EQ(found.jaccard, 0);
  EXPECT_NEAR(found.symmetric.mean, 1e4, 10);
}

TEST(NumSamples, IsTheNumberOfPartsOfAllTriangles) {
  // Edges of up to 10 sqrt(2) mm are cut into three parts, nine triangles.
  EXPECT_EQ(NumSamples(Box(10, 10, 10), 5), 12 * 9);
}

TEST(CompareSurfaces, EverythingScales) {
  TriangleSoup a = Icosphere(10, 1), b = Moved(Icosphere(10, 1), {3, 1, 0});
  const SurfaceComparison small = CompareSurfaces(a, b, {});
  a.points *= 10;
  b.points *= 10;
  const SurfaceComparison large = CompareSurfaces(a, b, {});
  EXPECT_NEAR(large.symmetric.mean, 10 * small.symmetric.mean, 1e-9);
  EXPECT_NEAR(large.symmetric.largest, 10 * small.symmetric.largest, 1e-9);
  EXPECT_NEAR(large.dice, small.dice, 1e-3);
}

TEST(CompareSurfaces, FinerSamplesChangeTheMeanLittle) {
  const TriangleSoup a = Box(40, 20, 10);
  const TriangleSoup b = Moved(a, {4, 2, 1});
  SurfaceComparisonOptions fine;
  fine.spacing = 0.25;
  SurfaceComparisonOptions coarse;
  coarse.spacing = 1;
  const double from_fine = CompareSurfaces(a, b, fine).symmetric.mean;
  const double from_coarse = CompareSurfaces(a, b, coarse).symmetric.mean;
  EXPECT_NEAR(from_fine, from_coarse, 0.05);
}

TEST(SurfaceComparisonOptions, NameTheFieldThatIsOutOfRange) {
  SurfaceComparisonOptions options;
  std::string error;
  EXPECT_TRUE(options.IsValid(&error));
  options.spacing = -1;
  EXPECT_FALSE(options.IsValid(&error));
  EXPECT_EQ(error,
            "SurfaceComparisonOptions::spacing is -1, allowed: 0 or above");
}

}  // namespace
}  // namespace musclewarp
