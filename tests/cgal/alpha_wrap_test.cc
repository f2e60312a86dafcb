// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/cgal/alpha_wrap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "musclewarp/geometry/outer_hull.h"
#include "musclewarp/mesh/defects.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/proximity/mesh_intersection.h"
#include "proximity/random_meshes.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

constexpr double kAlpha = 5;   // mm
constexpr double kOffset = 1;  // mm

void ExpectCleanAndAround(const TriangleSoup& wrap, const TriangleSoup& soup) {
  EXPECT_TRUE(CountDefects(wrap).IsClean());
  EXPECT_TRUE(SelfIntersections(wrap).empty());
  EXPECT_GT(SignedVolume(wrap.points, wrap.triangles), 0);
  EXPECT_TRUE(Encloses(wrap, soup));
}

}  // namespace

TEST(AlphaWrap, IsACleanSurfaceAroundAMesh) {
  const TriangleSoup spindle = Spindle(10, 30, 3);
  ExpectCleanAndAround(AlphaWrap(spindle, kAlpha, kOffset), spindle);
}

TEST(AlphaWrap, IsACleanSurfaceAroundSeparateTriangles) {
  std::mt19937 random(1);
  TriangleSoup soup = RandomSoup(/*count=*/60, /*size=*/0.5, &random);
  soup.points *= 10;
  // One of them is there twice.
  soup.triangles.row(2) = soup.triangles.row(1);
  ExpectCleanAndAround(AlphaWrap(soup, kAlpha, kOffset), soup);
}

TEST(AlphaWrap, TrianglesWithoutAreaDoNotCount) {
  const TriangleSoup box = Box(40, 30, 20);
  // A segment far away from the box.
  TriangleSoup segment;
  segment.points.resize(2, 3);
  segment.points << 100, 0, 0, 110, 0, 0;
  segment.triangles.resize(1, 3);
  segment.triangles << 0, 1, 1;
  const TriangleSoup wrap = AlphaWrap(Together(box, segment), kAlpha, kOffset);
  ExpectCleanAndAround(wrap, box);
  EXPECT_LT(wrap.points.col(0).maxCoeff(), 50);
}

TEST(AlphaWrap, VerticesStayTheOffsetAway) {
  // CGAL finds points on the offset surface by bisection, to some percent.
  constexpr double kShare = 0.1;
  const TriangleSoup box = Box(40, 30, 20);
  const TriangleBvh surface(box.points, box.triangles);
  const TriangleSoup wrap = AlphaWrap(box, kAlpha, kOffset);
  for (Eigen::Index v = 0; v < wrap.points.rows(); ++v) {
    EXPECT_NEAR(surface.ClosestPoint(wrap.points.row(v)).distance,
                kOffset,
                kShare * kOffset);
  }
}

TEST(AlphaWrap, EntersNoHoleNarrowerThanAlpha) {
  // An open box with a mouth of 10 mm by 10 mm: its inside of 1000 mm^3 is
  // wrapped over by a large alpha and entered by a small one.
  TriangleSoup box = LatticeBox(10, 10, 10);
  std::vector<int> keep;
  for (int f = 0; f < box.triangles.rows(); ++f) {
    double lowest = 10;
    for (int k = 0; k < 3; ++k) {
      lowest = std::min(lowest, box.points(box.triangles(f, k), 2));
    }
    if (lowest < 10) keep.push_back(f);
  }
  Triangles open(keep.size(), 3);
  for (size_t i = 0; i < keep.size(); ++i) {
    open.row(i) = box.triangles.row(keep[i]);
  }
  box.triangles = open;
  const auto volume = [&](double alpha) {
    const TriangleSoup wrap = AlphaWrap(box, alpha, /*offset=*/0.2);
    return SignedVolume(wrap.points, wrap.triangles);
  };
  EXPECT_GT(volume(/*alpha=*/40), 1000);
  EXPECT_LT(volume(/*alpha=*/2), 500);
}

}  // namespace musclewarp
