// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_repair/hole_filling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "musclewarp/mesh/defects.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/mesh/triangle.h"
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

// A funnel whose border, seen from above, runs counterclockwise through the
// corners of a hole. Corner k has the number k + shift, from 0 again at the
// end: a filling is searched from the corner of the lowest number.
TriangleSoup FunnelBelow(const Points& corners, int shift) {
  const int count = static_cast<int>(corners.rows());
  TriangleSoup funnel;
  funnel.points.resize(count + 1, 3);
  funnel.points.row(count) = corners.colwise().mean();
  funnel.points(count, 2) -= 9;
  funnel.triangles.resize(count, 3);
  for (int k = 0; k < count; ++k) {
    const int from = (k + shift) % count, to = (k + 1 + shift) % count;
    funnel.points.row(from) = corners.row(k);
    funnel.triangles.row(k) << to, from, count;
  }
  return funnel;
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

// The middle of an edge of the hole is a corner of it, too. A triangle within
// this edge would have no area, and the others could be as large as without it.
TEST(HoleFilling, NoTriangleOfAFillingIsFlatIfItNeedNotBe) {
  Points corners(5, 3);
  corners << 0, 0, 0, 1, 0, 0, 2, 0, 0, 2, 3, 0, 0, 3, 0;
  for (const double size : {1e-3, 1.0, 1e3}) {
    for (int shift = 0; shift < 5; ++shift) {
      TriangleSoup soup = FunnelBelow(size * corners, shift);
      HoleLimits limits;
      limits.max_perimeter = 1e6;
      const Fillings fillings = FillHoles(limits, &soup);
      ASSERT_EQ(fillings.triangles, 3);
      EXPECT_NEAR(fillings.area / (size * size), 6, kFillingRounding);
      for (int f = 5; f < 8; ++f) {
        EXPECT_GT(SurfaceArea(soup.points, soup.triangles.row(f)),
                  0.1 * size * size);
      }
    }
  }
}

// Two corners in one place: a triangle between them has no area whatever one
// does. What is left is filled by the better of two diagonals nevertheless.
TEST(HoleFilling, AFlatTriangleThatHasToBeLeavesTheOthersBest) {
  for (const int raised : {2, 3, 4}) {
    Points corners(5, 3);
    corners << 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0;
    corners(raised, 2) = 0.7;
    const auto area_of = [&](int a, int b, int c) {
      return AreaVector(CornersOf(corners, {a, b, c})).norm() / 2;
    };
    const double one = area_of(0, 2, 3) + area_of(0, 3, 4);
    const double other = area_of(2, 3, 4) + area_of(2, 4, 0);
    // Beside the penalty of a flat triangle, areas are known to this, mm^2.
    constexpr double kBesidePenalty = 1e-3;
    ASSERT_GT(std::abs(one - other), 10 * kBesidePenalty);
    for (int shift = 0; shift < 5; ++shift) {
      TriangleSoup soup = FunnelBelow(corners, shift);
      const Fillings fillings = FillHoles(HoleLimits(), &soup);
      EXPECT_EQ(fillings.triangles, 3);
      EXPECT_NEAR(fillings.area, std::min(one, other), kBesidePenalty)
          << "raised " << raised << " shift " << shift;
    }
  }
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
