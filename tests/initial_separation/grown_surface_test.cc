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

// Of the volume: the growth is looked for with coarser samples.
constexpr double kVolumeTolerance = 0.01;

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

}  // namespace
}  // namespace musclewarp
