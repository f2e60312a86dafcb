// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_repair/border_stitching.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "mesh_repair/battered_meshes.h"
#include "mesh_repair/repaired.h"
#include "musclewarp/mesh/defects.h"
#include "musclewarp/mesh/measures.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

constexpr double kTolerance = 0.3;  // mm

// A sphere of radius 10 mm whose upper part is a crack's width higher.
TriangleSoup CrackedSphere(double width) {
  TriangleSoup soup = Icosphere(10, 3);
  const auto num_points = soup.points.rows();
  TearOpen(3, &soup);
  soup.points.bottomRows(soup.points.rows() - num_points).col(2).array() +=
      width;
  return soup;
}

TEST(StitchBorders, MergesTheTwoSidesOfACrack) {
  TriangleSoup soup = CrackedSphere(0.02);
  const TriangleSoup cracked = soup;
  // Every border edge has a partner across the crack, and so has every point.
  const int pairs = CountDefects(soup).border_edges / 2;
  ASSERT_GT(pairs, 20);
  const Stitches stitches = StitchBorders(kTolerance, &soup);
  EXPECT_EQ(stitches.merged_points, pairs);
  EXPECT_EQ(stitches.inserted_points, 0);
  // Rounding of coordinates of size 10.
  EXPECT_NEAR(stitches.longest, 0.02, 1e-14);
  EXPECT_EQ(CountDefects(soup).border_edges, 0);
  EXPECT_TRUE(CountDefects(soup).is_closed_manifold);
  EXPECT_EQ(soup.points, cracked.points);
  EXPECT_EQ(soup.triangles.rows(), cracked.triangles.rows());
}

TEST(StitchBorders, LeavesAWideCrackOpen) {
  // Wider than the edges of the border are high, too.
  TriangleSoup soup = CrackedSphere(10 * kTolerance);
  const Triangles before = soup.triangles;
  const Stitches stitches = StitchBorders(kTolerance, &soup);
  EXPECT_EQ(stitches.merged_points + stitches.inserted_points, 0);
  EXPECT_EQ(soup.triangles, before);
}

TEST(StitchBorders, SplitsAnEdgeAtAPointBesideIt) {
  TriangleSoup soup = Icosphere(10, 3);
  const int middle =
      AddTJunction(300, 0.1 * Middle(soup, 300).normalized(), &soup);
  const auto num_triangles = soup.triangles.rows();
  const Stitches stitches = StitchBorders(kTolerance, &soup);
  EXPECT_EQ(stitches.inserted_points, 1);
  EXPECT_EQ(stitches.merged_points, 0);
  EXPECT_EQ(soup.triangles.rows(), num_triangles + 1);
  // Two triangles on each side of the edge that was.
  EXPECT_EQ((soup.triangles.array() == middle).count(), 4);
  EXPECT_TRUE(CountDefects(soup).is_closed_manifold);
}

TEST(StitchBorders, LeavesAClosedMeshAlone) {
  TriangleSoup soup = Icosphere(10, 2);
  const Triangles before = soup.triangles;
  EXPECT_EQ(StitchBorders(100, &soup).merged_points, 0);
  EXPECT_EQ(soup.triangles, before);
}

TEST(StitchBorders, DoesNotCloseTrianglesBackToBack) {
  TriangleSoup soup;
  for (const double z : {0.0, 0.1}) {
    for (const auto& [x, y] : {std::pair(0, 0), {3, 0}, {0, 3}}) {
      AddPoint(Eigen::RowVector3d(x, y, z), &soup);
    }
  }
  AddTriangle(0, 1, 2, &soup);
  AddTriangle(3, 5, 4, &soup);
  StitchBorders(kTolerance, &soup);
  const MeshDefects defects = CountDefects(soup);
  EXPECT_EQ(defects.duplicate_triangles, 0);
  EXPECT_EQ(defects.non_manifold_edges, 0);
  EXPECT_EQ(defects.misoriented_edges, 0);
  EXPECT_GT(defects.border_edges, 0);
}

TEST(StitchBorders, TheOrderOfTrianglesDoesNotMatter) {
  const TriangleSoup cracked = CrackedSphere(0.02);
  TriangleSoup stitched = cracked;
  const Stitches stitches = StitchBorders(kTolerance, &stitched);
  TriangleSoup reversed = cracked;
  reversed.triangles = cracked.triangles.colwise().reverse().eval();
  const Stitches again = StitchBorders(kTolerance, &reversed);
  EXPECT_EQ(again.merged_points, stitches.merged_points);
  EXPECT_EQ(again.longest, stitches.longest);
  // The same triangles; 4e3 mm^3 summed from 1280 terms in another order.
  EXPECT_NEAR(Volume(reversed), Volume(stitched), 1e-9);
}

TEST(StitchBordersDeathTest, InconsistentTrianglesAreAProgrammerError) {
  TriangleSoup soup = UnitTetrahedron();
  soup.triangles.row(0).reverseInPlace();
  EXPECT_DEATH(StitchBorders(kTolerance, &soup), "run the same way");
}

}  // namespace
}  // namespace musclewarp
