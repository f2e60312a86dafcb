// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/grown_surface.h"

#include <gtest/gtest.h>

#include "certified_contact/solid.h"
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

// A sheet of 40 x 60 x 6 mm whose lower third lies in a bone.
struct SheetOnABone {
  Solid sheet{MovedBy(Box(40, 60, 6), {0, 0, 3})};
  Solid bone{MovedBy(Box(100, 100, 10), {0, 0, -3})};

  CellSurfaceOptions Options() const {
    CellSurfaceOptions options;
    options.cell.margin = 0.2;
    options.volume = VolumeOf(Delivered());
    return options;
  }
  TriangleSoup Delivered() const {
    return {sheet.mesh.points(), sheet.mesh.triangles()};
  }
  TriangleSoup Surface(CellSurfaceOptions options) const {
    return CellSurface(options, sheet.distance, {}, {&bone.distance});
  }
};

TEST(GrownSurface, WhatABoneCutsOffComesBackOnTheFreeSide) {
  const SheetOnABone scene;
  CellSurfaceOptions without = scene.Options();
  without.volume = 0;
  EXPECT_LT(VolumeOf(scene.Surface(without)), 0.7 * scene.Options().volume);
  const TriangleSoup grown = scene.Surface(scene.Options());
  EXPECT_TRUE(CountDefects(grown).IsClean());
  EXPECT_TRUE(SelfIntersections(grown).empty());
  EXPECT_NEAR(VolumeOf(grown),
              scene.Options().volume,
              kVolumeTolerance * scene.Options().volume);
  // Nowhere in the bone, and by no more than what was cut off beyond its top.
  EXPECT_GT(grown.points.col(2).minCoeff(), 2);
  EXPECT_LT(grown.points.col(2).maxCoeff(), 9);
}

// What lies beyond a plate belongs to nobody: growth does not reach through it.
TEST(GrownSurface, DoesNotReachThroughAThinBone) {
  const Solid sheet(MovedBy(Box(40, 60, 8), {0, 0, 3}));
  const Solid plate(MovedBy(Box(100, 100, 2), {0, 0, 1}));
  CellSurfaceOptions options;
  options.volume = VolumeOf({sheet.mesh.points(), sheet.mesh.triangles()});
  const TriangleSoup grown =
      CellSurface(options, sheet.distance, {}, {&plate.distance});
  EXPECT_GT(grown.points.col(2).minCoeff(), 2);
  EXPECT_NEAR(
      VolumeOf(grown), options.volume, kVolumeTolerance * options.volume);
}

// Two sheets that lie in each other grow away from each other, and do not
// cross.
TEST(GrownSurface, MusclesThatOverlapGrowApart) {
  const Solid low(MovedBy(Box(40, 60, 6), {0, 0, 3}));
  const Solid high(MovedBy(Box(40, 60, 6), {0, 0, 7}));
  CellSurfaceOptions options;
  options.volume = VolumeOf({low.mesh.points(), low.mesh.triangles()});
  const TriangleSoup a =
      CellSurface(options, low.distance, {&high.distance}, {});
  const TriangleSoup b =
      CellSurface(options, high.distance, {&low.distance}, {});
  EXPECT_NEAR(VolumeOf(a), options.volume, kVolumeTolerance * options.volume);
  EXPECT_NEAR(VolumeOf(b), options.volume, kVolumeTolerance * options.volume);
  EXPECT_TRUE(IntersectMeshes(SearchableMesh(a), SearchableMesh(b)).IsEmpty());
}

// A muscle of which next to nothing is left is not blown up to its old size.
TEST(GrownSurface, DoesNotGrowFromNextToNothing) {
  const SheetOnABone scene;
  CellSurfaceOptions options = scene.Options();
  options.least_left = 0.9 * options.volume;
  EXPECT_LT(VolumeOf(scene.Surface(options)), 0.7 * options.volume);
}

}  // namespace
}  // namespace musclewarp
