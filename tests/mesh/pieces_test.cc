// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh/pieces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "musclewarp/mesh/measures.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

// A volume of 4e3 mm^3 summed from some hundred terms in another order.
constexpr double kVolumeSumRounding = 1e-9;

TEST(PiecesOf, SeparatesAndJoinedPutsBackTogether) {
  const TriangleSoup a = SphereAt({0, 0, 0}, 10, 2);
  const TriangleSoup b = SphereAt({30, 0, 0}, 5, 1);
  const std::vector<TriangleSoup> pieces = PiecesOf(Together(a, b));
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_EQ(pieces[0].points, a.points);
  EXPECT_EQ(pieces[0].triangles, a.triangles);
  EXPECT_EQ(pieces[1].points, b.points);
  EXPECT_EQ(pieces[1].triangles, b.triangles);
  const TriangleSoup joined = Joined(pieces);
  EXPECT_EQ(joined.points, Together(a, b).points);
  EXPECT_EQ(joined.triangles, Together(a, b).triangles);
}

TEST(PiecesOf, ThereAreNoneOfAnEmptyMesh) {
  EXPECT_TRUE(PiecesOf({}).empty());
  EXPECT_EQ(Joined({}).triangles.rows(), 0);
}

TEST(EnclosedVolume, IsTheVolumeOfAClosedPieceWhereverItLies) {
  for (const double x : {0.0, 1e4}) {
    const TriangleSoup sphere = SphereAt({x, 0, 0}, 10, 3);
    // Far from the origin the terms of the volume are a thousand times larger.
    EXPECT_NEAR(EnclosedVolume(sphere),
                SignedVolume(Icosphere(10, 3).points, sphere.triangles),
                1e3 * kVolumeSumRounding);
  }
}

TEST(EnclosedVolume, AFlatHoleIsClosedByALid) {
  TriangleSoup box = MovedBy(Box(2, 4, 6), {100, 0, 0});
  std::vector<int> sides;
  for (int f = 0; f < box.triangles.rows(); ++f) {
    const bool is_top = box.points(box.triangles(f, 0), 2) > 0 &&
                        box.points(box.triangles(f, 1), 2) > 0 &&
                        box.points(box.triangles(f, 2), 2) > 0;
    if (!is_top) sides.push_back(f);
  }
  ASSERT_EQ(sides.size(), 10u);
  box.triangles = box.triangles(sides, Eigen::all).eval();
  EXPECT_NEAR(EnclosedVolume(box), 48, kVolumeSumRounding);
}

}  // namespace
}  // namespace musclewarp
