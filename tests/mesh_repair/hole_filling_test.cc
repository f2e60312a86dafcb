// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_repair/hole_filling.h"

#include <gtest/gtest.h>

#include <utility>

#include "musclewarp/mesh/defects.h"
#include "musclewarp/mesh/measures.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

// Sums of a dozen terms of size 100.
constexpr double kFillingRounding = 1e-12;

TriangleSoup BoxWithoutLid(double x, double y, double z) {
  TriangleSoup box = Box(x, y, z);
  // Rows 2 and 3 are the side at +z.
  Triangles rest(10, 3);
  rest << box.triangles.topRows<2>(), box.triangles.bottomRows<8>();
  box.triangles = rest;
  return box;
}

// Limits under which the lid of a box is a hole as any other.
HoleLimits WithoutMissingFaces() {
  HoleLimits limits;
  limits.face_edges = 0;
  return limits;
}

TEST(HoleFilling, TheLidOfABoxIsFlat) {
  TriangleSoup box = BoxWithoutLid(2, 3, 4);
  const Fillings fillings = FillHoles(HoleLimits(), &box);
  EXPECT_EQ(fillings.holes, 1);
  EXPECT_EQ(fillings.triangles, 2);
  EXPECT_EQ(fillings.points, 0);
  EXPECT_NEAR(fillings.area, 6, kFillingRounding);
  EXPECT_NEAR(fillings.longest, 10, kFillingRounding);
  EXPECT_NEAR(
      SignedVolume(box.points, box.triangles), 24, 100 * kFillingRounding);
  EXPECT_TRUE(CountDefects(box).IsClean());
}

TEST(HoleFilling, AHoleBeyondTheLimitStaysOpen) {
  TriangleSoup box = BoxWithoutLid(2, 3, 4);
  HoleLimits limits = WithoutMissingFaces();
  limits.max_perimeter = 9.9;
  EXPECT_EQ(FillHoles(limits, &box).holes, 0);
  EXPECT_EQ(box.triangles.rows(), 10);
  EXPECT_EQ(box.points.rows(), 8);
}

TEST(HoleFilling, ALongSlitIsFilled) {
  TriangleSoup box = BoxWithoutLid(100, 0.5, 4);
  HoleLimits limits = WithoutMissingFaces();
  limits.max_perimeter = 10;
  const Fillings fillings = FillHoles(limits, &box);
  EXPECT_EQ(fillings.holes, 1);
  EXPECT_NEAR(fillings.longest, 201, 100 * kFillingRounding);
  EXPECT_TRUE(CountDefects(box).IsClean());
}

// The area of the lid over the square of its border is 0.00595 and 0.00618.
TEST(HoleFilling, ALongHoleIsFilledIfItIsNarrowEnough) {
  for (const auto& [width, is_slit] : {std::pair(2.5, true), {2.6, false}}) {
    TriangleSoup box = BoxWithoutLid(100, width, 4);
    EXPECT_EQ(FillHoles(WithoutMissingFaces(), &box).holes, is_slit) << width;
  }
}

TEST(HoleFilling, AMissingFaceIsFilledWhateverItsSize) {
  for (const double size : {1.0, 1000.0}) {
    TriangleSoup box = BoxWithoutLid(2 * size, 3 * size, 4 * size);
    const Fillings fillings = FillHoles(HoleLimits(), &box);
    EXPECT_EQ(fillings.holes, 1);
    // Named where the other limits would not have allowed it.
    EXPECT_EQ(fillings.missing_faces, size > 1);
    EXPECT_TRUE(CountDefects(box).IsClean());
  }
  TriangleSoup without_triangle = Box(1000, 1000, 1000);
  without_triangle.triangles.conservativeResize(11, 3);
  EXPECT_EQ(FillHoles(HoleLimits(), &without_triangle).missing_faces, 1);
  // A hole of five edges, around a corner of an icosahedron, may be anything.
  TriangleSoup without_corner = Icosphere(1000, 0);
  Triangles rest(15, 3);
  Eigen::Index kept = 0;
  for (const auto& triangle : without_corner.triangles.rowwise()) {
    if ((triangle.array() != 0).all()) rest.row(kept++) = triangle;
  }
  ASSERT_EQ(kept, 15);
  without_corner.triangles = rest;
  EXPECT_EQ(FillHoles(HoleLimits(), &without_corner).holes, 0);
}

TEST(HoleFilling, AHoleOfTooManyEdgesStaysOpen) {
  TriangleSoup box = BoxWithoutLid(2, 3, 4);
  HoleLimits limits;
  limits.max_edges = 3;
  EXPECT_EQ(FillHoles(limits, &box).holes, 0);
  limits.max_edges = 4;
  EXPECT_EQ(FillHoles(limits, &box).holes, 1);
}

TEST(HoleFilling, TheDiagonalAvoidsAnEdgeThatIsThere) {
  // Two sides of a tetrahedron that share an edge: the hole is the other two.
  TriangleSoup tetrahedron = UnitTetrahedron();
  tetrahedron.triangles.conservativeResize(2, 3);
  const Fillings fillings = FillHoles(HoleLimits(), &tetrahedron);
  EXPECT_EQ(fillings.triangles, 2);
  EXPECT_NEAR(SignedVolume(tetrahedron.points, tetrahedron.triangles),
              1.0 / 6,
              kFillingRounding);
  EXPECT_TRUE(CountDefects(tetrahedron).IsClean());
}

TEST(HoleFilling, HolesThatMeetInAPointAreTwo) {
  TriangleSoup sphere = Icosphere(10, 2);
  // Two triangles that share a point and nothing else.
  const int v = sphere.triangles(0, 0);
  std::vector<int> around;
  for (int f = 0; f < sphere.triangles.rows(); ++f) {
    if ((sphere.triangles.row(f).array() == v).any()) around.push_back(f);
  }
  const auto shares_an_edge = [&](int f, int g) {
    int common = 0;
    for (int c = 0; c < 3; ++c) {
      common +=
          (sphere.triangles.row(f).array() == sphere.triangles(g, c)).any();
    }
    return common > 1;
  };
  const auto other = std::find_if(around.begin(), around.end(), [&](int f) {
    return !shares_an_edge(around[0], f);
  });
  ASSERT_NE(other, around.end());
  const double volume = SignedVolume(sphere.points, sphere.triangles);
  const int last = static_cast<int>(sphere.triangles.rows());
  sphere.triangles.row(*other) = sphere.triangles.row(last - 1).eval();
  sphere.triangles.row(around[0]) = sphere.triangles.row(last - 2).eval();
  sphere.triangles.conservativeResize(last - 2, 3);
  const auto loops = FindBorderLoops(sphere.triangles);
  ASSERT_EQ(loops.size(), 2u);
  EXPECT_EQ(loops[0].size(), 3u);
  EXPECT_EQ(loops[1].size(), 3u);
  FillHoles(HoleLimits(), &sphere);
  EXPECT_TRUE(CountDefects(sphere).IsClean());
  // 4e3 mm^3 summed from 320 terms.
  EXPECT_NEAR(SignedVolume(sphere.points, sphere.triangles), volume, 1e-9);
}

}  // namespace
}  // namespace musclewarp
