// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_repair/piece_selection.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "mesh_repair/battered_meshes.h"
#include "mesh_repair/repaired.h"
#include "musclewarp/mesh/defects.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/mesh/pieces.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

// A volume of 4e3 mm^3 summed in another order.
constexpr double kPieceRounding = 1e-8;

TriangleSoup RepairedBone(const TriangleSoup& soup, RepairReport* report) {
  RepairOptions options;
  options.pieces.rule = PieceRule::kAll;
  const TriangleSoup repaired = RepairMesh(soup, "foot.ply", options, report);
  EXPECT_TRUE(CountDefects(repaired).IsCleanInPieces());
  EXPECT_EQ(report->pieces, CountDefects(repaired).components);
  return repaired;
}

std::string ReasonsOf(const RepairReport& report) {
  std::string reasons;
  for (const DroppedPiece& piece : report.dropped_pieces) {
    reasons += (reasons.empty() ? "" : " ") + ToString(piece.reason);
  }
  return reasons;
}

// The bones of a foot: large and small, apart, touching and in each other.
TriangleSoup Foot() {
  return Joined({SphereAt({0, 0, 0}, 20, 3),
                 SphereAt({35, 0, 0}, 18, 3),  // 3 mm deep in the first
                 SphereAt({0, 60, 0}, 5, 2),
                 SphereAt({0, -60, 0}, 1.5, 1)});  // 0.6 % of the largest
}

TEST(PieceSelection, CleanSurfacesComeBackBitByBit) {
  const TriangleSoup foot = Foot();
  RepairReport report;
  const TriangleSoup repaired = RepairedBone(foot, &report);
  EXPECT_EQ(repaired.points, foot.points);
  EXPECT_EQ(repaired.triangles, foot.triangles);
  EXPECT_EQ(report.pieces, 4);
  EXPECT_FALSE(report.AnythingDone());
}

TEST(PieceSelection, SurfacesInsideOutAreTurnedEachByItself) {
  TriangleSoup foot = Foot();
  const int first = Icosphere(1, 3).triangles.rows();
  for (int f = first; f < 2 * first; ++f) {
    foot.triangles.row(f).reverseInPlace();
  }
  RepairReport report;
  EXPECT_NEAR(
      Volume(RepairedBone(foot, &report)), Volume(Foot()), kPieceRounding);
  EXPECT_EQ(report.flipped_triangles, first);
}

TEST(PieceSelection, DoesNotDependOnTheSizeOfTheBody) {
  for (const double scale : {1.0 / 16, 1.0, 16.0}) {
    TriangleSoup foot = Foot();
    foot.points *= scale;
    RepairReport report;
    RepairedBone(foot, &report);
    EXPECT_EQ(report.pieces, 4) << scale;
  }
}

TEST(PieceSelection, CrumbsGoAndAreMeasured) {
  const TriangleSoup crumb = SphereAt({70, 0, 0}, 0.3, 1);
  RepairReport report;
  RepairedBone(Together(Foot(), crumb), &report);
  EXPECT_EQ(report.pieces, 4);
  ASSERT_EQ(ReasonsOf(report), "crumb");
  const DroppedPiece& dropped = report.dropped_pieces[0];
  EXPECT_EQ(dropped.triangles, crumb.triangles.rows());
  EXPECT_NEAR(
      dropped.area, SurfaceArea(crumb.points, crumb.triangles), kPieceRounding);
  EXPECT_NEAR(dropped.volume, Volume(crumb), kPieceRounding);
  EXPECT_NEAR(dropped.place.x(), 70, kPieceRounding);
}

TEST(PieceSelection, TheWallOfACavityGoes) {
  RepairReport report;
  const TriangleSoup foot = Foot();
  const TriangleSoup repaired =
      RepairedBone(Together(foot, SphereAt({0, 0, 0}, 15, 3)), &report);
  EXPECT_EQ(ReasonsOf(report), "shell");
  EXPECT_NEAR(Volume(repaired), Volume(foot), kPieceRounding);
}

TEST(PieceSelection, ALongBorderLeavesAPieceOpenAndAShortOneIsFilled) {
  for (const bool is_open : {false, true}) {
    TriangleSoup cut = SphereAt({0, 0, 0}, 15, 3);
    CutOff(is_open ? 5 : 14.5, &cut);
    RepairReport report;
    RepairedBone(Together(Foot(), MovedBy(cut, {0, 0, 80})), &report);
    EXPECT_EQ(report.pieces, is_open ? 4 : 5);
    EXPECT_EQ(ReasonsOf(report), is_open ? "open" : "");
  }
}

TEST(PieceSelection, OfAMuscleTheLargestStaysAndTheLossIsItsVolume) {
  RepairReport report;
  const TriangleSoup repaired =
      RepairMesh(Foot(), "muscle.ply", RepairOptions(), &report);
  EXPECT_TRUE(CountDefects(repaired).IsClean());
  EXPECT_EQ(ReasonsOf(report), "crumb smaller smaller");
  EXPECT_NEAR(Volume(repaired) + TotalsOf(report.dropped_pieces).volume,
              Volume(Foot()),
              kPieceRounding);
}

TEST(PieceSelection, TheOrderOfPiecesDoesNotMatter) {
  std::vector<TriangleSoup> pieces = PiecesOf(Foot());
  const std::vector<TriangleSoup> reversed = {pieces.rbegin(), pieces.rend()};
  RepairReport report;
  const TriangleSoup repaired = RepairedBone(Joined(reversed), &report);
  EXPECT_EQ(repaired.points, Joined(reversed).points);
  EXPECT_EQ(report.pieces, 4);
}

}  // namespace
}  // namespace musclewarp
