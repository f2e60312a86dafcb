// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/initial_separation/grown_surface.h"

#include <gtest/gtest.h>

#include "initial_separation/solid.h"
#include "musclewarp/mesh/defects.h"
#include "musclewarp/mesh/measures.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

// Of the volume: what a search stops at (growth_search.h), and rounding.
constexpr double kVolumeTolerance = 2.1e-3;

double VolumeOf(const TriangleSoup& soup) {
  return SignedVolume(soup.points, soup.triangles);
}

// What CellSurface() leaves of a muscle, grown to the volume that it had.
TriangleSoup Grown(const Solid& muscle,
                   const std::vector<const SolidDistance*>& others,
                   const std::vector<const SolidDistance*>& bones) {
  const CellSurfaceOptions options;
  const double volume =
      VolumeOf({muscle.mesh.points(), muscle.mesh.triangles()});
  return SurfaceGrowth(options,
                       CellSurface(options, muscle.distance, others, bones),
                       muscle.distance,
                       others,
                       bones,
                       volume)
      .UpTo(volume);
}

double VolumeOf(const Solid& solid) {
  return VolumeOf({solid.mesh.points(), solid.mesh.triangles()});
}

// A sheet of 40 x 60 x 6 mm whose lower third lies in a bone.
TEST(SurfaceGrowth, WhatABoneCutsOffComesBackOnTheFreeSide) {
  const Solid sheet(MovedBy(Box(40, 60, 6), {0, 0, 3}));
  const Solid bone(MovedBy(Box(100, 100, 10), {0, 0, -3}));
  EXPECT_LT(VolumeOf(CellSurface(
                CellSurfaceOptions(), sheet.distance, {}, {&bone.distance})),
            0.7 * VolumeOf(sheet));
  const TriangleSoup grown = Grown(sheet, {}, {&bone.distance});
  EXPECT_TRUE(CountDefects(grown).IsClean());
  EXPECT_TRUE(SelfIntersections(grown).empty());
  EXPECT_NEAR(
      VolumeOf(grown), VolumeOf(sheet), kVolumeTolerance * VolumeOf(sheet));
  // Nowhere in the bone, and by no more than what was cut off beyond its top.
  EXPECT_GT(grown.points.col(2).minCoeff(), 2);
  EXPECT_LT(grown.points.col(2).maxCoeff(), 9);
}

// What lies beyond a plate belongs to nobody: growth does not reach through it.
TEST(SurfaceGrowth, DoesNotReachThroughAThinBone) {
  const Solid sheet(MovedBy(Box(40, 60, 8), {0, 0, 3}));
  const Solid plate(MovedBy(Box(100, 100, 2), {0, 0, 1}));
  const TriangleSoup grown = Grown(sheet, {}, {&plate.distance});
  EXPECT_GT(grown.points.col(2).minCoeff(), 2);
  EXPECT_NEAR(
      VolumeOf(grown), VolumeOf(sheet), kVolumeTolerance * VolumeOf(sheet));
}

// Two sheets that lie in each other grow away from each other, and do not
// cross.
TEST(SurfaceGrowth, MusclesThatOverlapGrowApart) {
  const Solid low(MovedBy(Box(40, 60, 6), {0, 0, 3}));
  const Solid high(MovedBy(Box(40, 60, 6), {0, 0, 7}));
  const TriangleSoup a = Grown(low, {&high.distance}, {});
  const TriangleSoup b = Grown(high, {&low.distance}, {});
  EXPECT_NEAR(VolumeOf(a), VolumeOf(low), kVolumeTolerance * VolumeOf(low));
  EXPECT_NEAR(VolumeOf(b), VolumeOf(low), kVolumeTolerance * VolumeOf(low));
  EXPECT_TRUE(IntersectMeshes(SearchableMesh(a), SearchableMesh(b)).IsEmpty());
}

// A ball whose surface was cut off by coarse samples all round.
TEST(SurfaceGrowth, ABodyThatWasCutNowhereGrowsEvenly) {
  const Solid ball(Icosphere(10, 4));
  const CellSurfaceOptions options;
  const TriangleSoup body = CellSurface(options, ball.distance, {}, {});
  const double volume = 1.05 * VolumeOf(body);
  const TriangleSoup grown =
      SurfaceGrowth(options, body, ball.distance, {}, {}, volume).UpTo(volume);
  EXPECT_NEAR(VolumeOf(grown), volume, kVolumeTolerance * volume);
  for (const auto p : grown.points.rowwise()) {
    EXPECT_NEAR(p.norm(), 10.15, 0.2);
  }
}

// A muscle of 20 x 20 x 60 mm of which the upper half is left, asked for more
// than it can have. Below the cut, where a place is as far from the cut as from
// the body, growth by t reaches t - d / 3 = d: three quarters of t.
TEST(SurfaceGrowth, ReachesNoFartherThanSixTimesWhatWasCutOff) {
  const Solid muscle(Box(20, 20, 60));
  const TriangleSoup body = MovedBy(Box(20, 20, 30), {0, 0, 15});
  CellSurfaceOptions options;
  options.spacing = 2;
  const auto depth_for = [&](double thickness) {
    const double volume = VolumeOf(body) + thickness * 20 * 20;
    SurfaceGrowth growth(options, body, muscle.distance, {}, {}, volume);
    const TriangleSoup grown = growth.UpTo(100 * volume);
    EXPECT_TRUE(CountDefects(grown).IsClean());
    return -grown.points.col(2).minCoeff();
  };
  // Distances are linear below the cut: a surface between samples is exact, but
  // for what keeps it off their ends (marching_tetrahedra_test.cc).
  constexpr double kPlace = 0.1;  // mm
  EXPECT_NEAR(depth_for(2), 0.75 * 6 * 2, kPlace);
  EXPECT_NEAR(depth_for(4), 0.75 * 6 * 4, kPlace);
  // 30 mm at most, and as far as samples are apart at least.
  EXPECT_NEAR(depth_for(6), 0.75 * 30, kPlace);
  EXPECT_NEAR(depth_for(0.1), 0.75 * options.spacing, kPlace);
}

// A third less for each millimetre away from the cut: nothing from three times
// the reach on.
TEST(SurfaceGrowth, DeclinesAwayFromTheCut) {
  const Solid muscle(Box(20, 20, 100));
  const TriangleSoup body = MovedBy(Box(20, 20, 50), {0, 0, 25});
  CellSurfaceOptions options;
  options.spacing = 2;
  SurfaceGrowth growth(
      options, body, muscle.distance, {}, {}, VolumeOf(body) + 1.5 * 400);
  const TriangleSoup grown = growth.UpTo(2 * VolumeOf(body));  // by 9 mm
  for (const auto p : grown.points.rowwise()) {
    const double aside = p.head<2>().cwiseAbs().maxCoeff() - 10;
    // Beside the wall the cut is farther than its height above it.
    EXPECT_LT(aside, std::max(0.0, 9 - p[2] / 3) + 0.2);
    if (p[2] > 30 && p[2] < 49) {
      EXPECT_LT(aside, 0.2);
    }
  }
  EXPECT_GT(grown.points.leftCols<2>().maxCoeff(), 10 + 0.5 * 9);
}

TEST(SurfaceGrowth, LeavesABodyThatIsLargeEnough) {
  const Solid muscle(Box(20, 20, 60));
  const TriangleSoup body = MovedBy(Box(20, 20, 30), {0, 0, 15});
  SurfaceGrowth growth({}, body, muscle.distance, {}, {}, VolumeOf(body));
  EXPECT_EQ(growth.UpTo(VolumeOf(body)).points, body.points);
}

}  // namespace
}  // namespace musclewarp
