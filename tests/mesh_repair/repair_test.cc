// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_repair/repair.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

#include "mesh_repair/battered_meshes.h"
#include "mesh_repair/repaired.h"
#include "musclewarp/base/input_error.h"
#include "musclewarp/mesh/defects.h"
#include "musclewarp/mesh/measures.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

// A volume of 4e3 mm^3 summed in another order from 1280 terms.
constexpr double kVolumeRounding = 1e-9;
constexpr double kRadius = 10;

TriangleSoup Sphere() { return Icosphere(kRadius, 3); }

std::string Refusal(const TriangleSoup& soup, const RepairOptions& options) {
  try {
    RepairMesh(soup, "muscle.ply", options, nullptr);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// A sphere with one of nearly everything.
TriangleSoup BatteredSphere() {
  TriangleSoup soup = Sphere();
  TearOpen(3, &soup);
  AddTJunction(40, {0.05, 0, 0}, &soup);
  AddTJunction(700, {0, 0.01, 0}, &soup);
  soup.triangles.row(123).reverseInPlace();
  AddTriangle(soup.triangles(77, 1),
              soup.triangles(77, 2),
              soup.triangles(77, 0),
              &soup);
  const int tip = AddPoint({15, 0, 0}, &soup);
  AddTriangle(soup.triangles(200, 0), soup.triangles(200, 1), tip, &soup);
  TriangleSoup island = Icosphere(0.5, 1);
  island.points.col(0).array() += 20;
  AddSoup(island, &soup);
  soup.triangles.row(500) = soup.triangles.row(501).eval();
  return soup;
}

TEST(RepairMesh, ACleanMeshComesBackBitByBit) {
  RepairReport report;
  const TriangleSoup sphere = Sphere();
  const TriangleSoup repaired = Repaired(sphere, &report);
  EXPECT_EQ(repaired.points, sphere.points);
  EXPECT_EQ(repaired.triangles, sphere.triangles);
  EXPECT_FALSE(report.AnythingDone());
}

TEST(RepairMesh, ASeamOfDuplicatePointsIsMerged) {
  TriangleSoup soup = Sphere();
  TearOpen(3, &soup);
  const int duplicates = CountDefects(soup).duplicate_points;
  ASSERT_GT(CountDefects(soup).border_edges, 20);
  RepairReport report;
  const TriangleSoup repaired = Repaired(soup, &report);
  EXPECT_EQ(report.point_merges.merged, duplicates);
  EXPECT_EQ(report.point_merges.longest, 0);
  EXPECT_EQ(repaired.points, Sphere().points);
  EXPECT_EQ(repaired.triangles, Sphere().triangles);
}

TEST(RepairMesh, ATJunctionIsStitchedAndNothingElseMoves) {
  constexpr double kWidth = 0.1;
  TriangleSoup soup = Sphere();
  const double volume = Volume(soup);
  AddTJunction(300, Middle(soup, 300).normalized() * kWidth, &soup);
  RepairReport report;
  const TriangleSoup repaired = Repaired(soup, &report);
  EXPECT_EQ(report.stitches.inserted_points, 1);
  EXPECT_NEAR(report.stitches.longest, kWidth, 0.01 * kWidth);
  EXPECT_EQ(repaired.points, soup.points);
  EXPECT_EQ(repaired.triangles.rows(), Sphere().triangles.rows() + 2);
  // The bent edge lifts two triangles of about 1 mm^2 by a third of the width.
  EXPECT_NEAR(Volume(repaired), volume, kWidth);
}

TEST(RepairMesh, ACrackBetweenTwoBordersIsZipped) {
  constexpr double kWidth = 0.02;
  TriangleSoup soup = Sphere();
  const double volume = Volume(soup);
  const auto num_points = soup.points.rows();
  TearOpen(3, &soup);
  soup.points.bottomRows(soup.points.rows() - num_points).col(2).array() +=
      kWidth;
  RepairReport report;
  const TriangleSoup repaired = Repaired(soup, &report);
  EXPECT_GT(report.stitches.merged_points, 20);
  EXPECT_NEAR(report.stitches.longest, kWidth, 1e-12);
  EXPECT_EQ(repaired.points.rows(), num_points);
  // The cap lies a crack's width higher over a disc of at most pi r^2.
  EXPECT_NEAR(Volume(repaired), volume, kWidth * M_PI * kRadius * kRadius);
}

TEST(RepairMesh, ASliverOfNoAreaGoesAndLeavesNoCrack) {
  TriangleSoup soup = Box(2, 3, 4);
  const int a = soup.triangles(0, 0);
  const int b = soup.triangles(0, 1);
  const int middle = AddTJunction(0, {0, 0, 0}, &soup);
  AddTriangle(a, b, middle, &soup);
  ASSERT_TRUE(CountDefects(soup).is_closed_manifold);
  ASSERT_EQ(CountDefects(soup).degenerate_triangles, 1);
  RepairReport report;
  const TriangleSoup repaired = Repaired(soup, &report);
  EXPECT_EQ(report.degenerate_triangles, 1);
  EXPECT_EQ(report.stitches.inserted_points, 1);
  EXPECT_EQ(report.stitches.longest, 0);
  EXPECT_EQ(repaired.points, soup.points);
  EXPECT_NEAR(Volume(repaired), 24, kVolumeRounding);
}

TEST(RepairMesh, AFlippedPatchIsTurned) {
  TriangleSoup soup = Sphere();
  int flipped = 0;
  for (int f = 0; f < soup.triangles.rows(); ++f) {
    if (Middle(soup, f).z() < 5) continue;
    soup.triangles.row(f).reverseInPlace();
    ++flipped;
  }
  RepairReport report;
  EXPECT_NEAR(
      Volume(Repaired(soup, &report)), Volume(Sphere()), kVolumeRounding);
  EXPECT_EQ(report.flipped_triangles, flipped);
}

TEST(RepairMesh, AnInsideOutMeshIsTurned) {
  TriangleSoup soup = Sphere();
  soup.triangles.col(1).swap(soup.triangles.col(2));
  RepairReport report;
  const TriangleSoup repaired = Repaired(soup, &report);
  EXPECT_EQ(repaired.triangles, Sphere().triangles);
  EXPECT_EQ(report.flipped_triangles, soup.triangles.rows());
}

TEST(RepairMesh, ADoubledTriangleGoesWhicheverWayItFaces) {
  for (const bool reversed : {false, true}) {
    TriangleSoup soup = Sphere();
    AddTriangle(soup.triangles(9, reversed ? 2 : 0),
                soup.triangles(9, 1),
                soup.triangles(9, reversed ? 0 : 2),
                &soup);
    RepairReport report;
    EXPECT_EQ(Repaired(soup, &report).triangles, Sphere().triangles);
    EXPECT_EQ(report.duplicate_triangles, 1);
  }
}

TEST(RepairMesh, AFinIsCutOff) {
  for (const double radius : {0.8 * kRadius, 1.2 * kRadius}) {
    TriangleSoup soup = Sphere();
    const int tip = AddPoint(Middle(soup, 50).normalized() * radius, &soup);
    AddTriangle(soup.triangles(50, 0), soup.triangles(50, 1), tip, &soup);
    RepairReport report;
    const TriangleSoup repaired = Repaired(soup, &report);
    EXPECT_EQ(repaired.points, Sphere().points);
    EXPECT_EQ(repaired.triangles, Sphere().triangles);
    EXPECT_EQ(report.separation.edges, 1);
    EXPECT_EQ(TotalsOf(report.dropped_pieces).triangles, 1);
  }
}

TEST(RepairMesh, IslandsAreDroppedAndReported) {
  TriangleSoup soup = Sphere();
  TriangleSoup island = Icosphere(3, 1);
  island.points.col(0).array() += 20;
  AddSoup(island, &soup);
  RepairReport report;
  EXPECT_EQ(Repaired(soup, &report).points, Sphere().points);
  EXPECT_EQ(report.dropped_pieces.size(), 1);
  EXPECT_EQ(TotalsOf(report.dropped_pieces).triangles, island.triangles.rows());
  EXPECT_NEAR(TotalsOf(report.dropped_pieces).area,
              SurfaceArea(island.points, island.triangles),
              kVolumeRounding);
  EXPECT_EQ(TotalsOf(report.dropped_pieces).largest_area,
            TotalsOf(report.dropped_pieces).area);
}

TEST(RepairMesh, AMissingTriangleIsPutBack) {
  TriangleSoup soup = Sphere();
  soup.triangles.conservativeResize(soup.triangles.rows() - 1, 3);
  RepairReport report;
  const TriangleSoup repaired = Repaired(soup, &report);
  EXPECT_EQ(report.fillings.holes, 1);
  EXPECT_EQ(report.fillings.triangles, 1);
  EXPECT_NEAR(Volume(repaired), Volume(Sphere()), kVolumeRounding);
}

TEST(RepairMesh, AMissingCapIsRefusedWithThePlace) {
  TriangleSoup soup = Sphere();
  CutOff(6, &soup);
  const MeshDefects defects = CountDefects(soup);
  const std::string refusal = Refusal(soup, RepairOptions());
  EXPECT_THAT(
      refusal,
      AllOf(HasSubstr("muscle.ply"),
            HasSubstr("an open border of " +
                      std::to_string(defects.border_edges) + " edges"),
            HasSubstr("mm long, around ("),
            HasSubstr("allowed: holes of up to 30 mm or narrow slits")));
  RepairOptions options;
  options.holes.max_perimeter = 60;
  EXPECT_EQ(Refusal(soup, options), "");
}

TEST(RepairMesh, AMoebiusStripIsRefused) {
  EXPECT_THAT(Refusal(MoebiusStrip(), RepairOptions()),
              HasSubstr("one side only"));
}

TEST(RepairMesh, NoTrianglesAreRefused) {
  EXPECT_THAT(Refusal(TriangleSoup(), RepairOptions()),
              HasSubstr("no closed surface"));
}

TEST(RepairMesh, RepairingTwiceChangesNothingMore) {
  RepairReport report;
  const TriangleSoup once = Repaired(BatteredSphere(), &report);
  EXPECT_TRUE(report.AnythingDone());
  const TriangleSoup twice = Repaired(once, &report);
  EXPECT_FALSE(report.AnythingDone());
  EXPECT_EQ(twice.points, once.points);
  EXPECT_EQ(twice.triangles, once.triangles);
}

TEST(RepairMesh, TheOrderOfTrianglesDoesNotMatter) {
  const TriangleSoup soup = BatteredSphere();
  RepairReport report;
  const double volume = Volume(Repaired(soup, &report));
  std::mt19937 random(5);
  std::vector<int> order(soup.triangles.rows());
  std::iota(order.begin(), order.end(), 0);
  for (int trial = 0; trial < 5; ++trial) {
    std::shuffle(order.begin(), order.end(), random);
    TriangleSoup shuffled = soup;
    for (size_t f = 0; f < order.size(); ++f) {
      shuffled.triangles.row(f) = soup.triangles.row(order[f]);
    }
    const MeshDefects before = CountDefects(soup);
    const MeshDefects after = CountDefects(shuffled);
    EXPECT_EQ(before.border_edges, after.border_edges);
    EXPECT_EQ(before.non_manifold_edges, after.non_manifold_edges);
    EXPECT_EQ(before.non_manifold_vertices, after.non_manifold_vertices);
    EXPECT_EQ(before.misoriented_edges, after.misoriented_edges);
    EXPECT_EQ(before.components, after.components);
    RepairReport again;
    EXPECT_NEAR(Volume(Repaired(shuffled, &again)), volume, kVolumeRounding);
    EXPECT_EQ(again.stitches.inserted_points, report.stitches.inserted_points);
    EXPECT_EQ(TotalsOf(again.dropped_pieces).triangles,
              TotalsOf(report.dropped_pieces).triangles);
    EXPECT_EQ(again.fillings.holes, report.fillings.holes);
  }
}

}  // namespace
}  // namespace musclewarp
