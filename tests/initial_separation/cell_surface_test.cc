// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/initial_separation/cell_surface.h"

#include <gtest/gtest.h>

#include <cmath>

#include "initial_separation/solid.h"
#include "musclewarp/mesh/defects.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/proximity/mesh_intersection.h"
#include "support/invalid_options.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

const double kUnitBall = 4 * std::acos(-1.0) / 3;  // its volume

// A margin that covers what the remeshing of a surface with edges of 1 to 2 mm
// cuts off a ball of 10 mm: 2^2 / (8 * 10).
CellSurfaceOptions SurfaceOptions() {
  CellSurfaceOptions options;
  options.cell.margin = 0.4;
  return options;
}

// With triangles of the size that those of the muscle have.
TriangleSoup EvenCellSurface(const Solid& muscle,
                             const std::vector<const SolidDistance*>& others,
                             const std::vector<const SolidDistance*>& bones) {
  const double typical =
      TypicalEdge(muscle.mesh.points(), muscle.mesh.triangles());
  const double spacing = SurfaceOptions().spacing;
  return WithEvenTriangles(
      CellSurface(SurfaceOptions(), muscle.distance, others, bones),
      std::max(spacing, typical));
}

void ExpectClean(const TriangleSoup& surface) {
  EXPECT_TRUE(CountDefects(surface).IsClean());
  EXPECT_TRUE(SelfIntersections(surface).empty());
  EXPECT_GT(SignedVolume(surface.points, surface.triangles), 0);
}

}  // namespace

TEST(WithEvenTriangles, LeavesAThinMuscleItsVolume) {
  // A strap 2 mm thick: with edges of 6 mm a third of its volume would go.
  TriangleSoup strap = Icosphere(1, 5);
  strap.points *= Eigen::Vector3d(30, 5, 1).asDiagonal();
  const double volume = SignedVolume(strap.points, strap.triangles);
  const TriangleSoup even = WithEvenTriangles(strap, 6);
  ExpectClean(even);
  EXPECT_GT(SignedVolume(even.points, even.triangles), 0.95 * volume);
  EXPECT_LT(even.triangles.rows(), strap.triangles.rows());
}

TEST(CellSurface, OfAMuscleAloneIsItsOwn) {
  const Solid muscle(Icosphere(10, 4));
  const TriangleSoup surface = EvenCellSurface(muscle, {}, {});
  ExpectClean(surface);
  for (const auto p : surface.points.rowwise()) {
    EXPECT_NEAR(p.norm(), 10, 0.2);
  }
  // Two per cent are lost along the edges.
  EXPECT_NEAR(SignedVolume(surface.points, surface.triangles),
              kUnitBall * 1000,
              0.03 * kUnitBall * 1000);
}

// A tube whose walls cross each other has no inside there.
TEST(CellSurface, BridgesAPlaceWhereTheMuscleIsPinchedOff) {
  TriangleSoup tube = Spindle(6, 40, 4);
  for (auto p : tube.points.rowwise()) {
    // In the middle the left wall is on the right, and the inside outside.
    if (std::abs(p[2]) < 3) p[0] *= -0.5;
  }
  ASSERT_FALSE(SelfIntersections(tube).empty());
  const Solid muscle(tube);
  CellSurfaceOptions options = SurfaceOptions();
  const auto height = [&] {
    const TriangleSoup surface = CellSurface(options, muscle.distance, {}, {});
    const MeshDefects defects = CountDefects(surface);
    EXPECT_TRUE(defects.IsClean())
        << defects.border_edges << " " << defects.non_manifold_edges << " "
        << defects.non_manifold_vertices << " " << defects.components << " "
        << defects.degenerate_triangles << " " << defects.duplicate_points
        << " " << defects.unreferenced_points;
    return surface.points.col(2).maxCoeff() - surface.points.col(2).minCoeff();
  };
  EXPECT_LT(height(), 50);
  options.bridge = 1.25;
  EXPECT_GT(height(), 70);
}

TEST(CellSurface, DoesNotCrossBoneOrTheOtherMuscle) {
  const Solid left(MovedBy(Icosphere(10, 4), {-7, 0, 0}));
  const Solid right(MovedBy(Icosphere(10, 3), {7, 0, 0}));
  const Solid bone(MovedBy(Box(60, 60, 10), {0, 0, -10}));
  const TriangleSoup a =
      EvenCellSurface(left, {&right.distance}, {&bone.distance});
  const TriangleSoup b =
      EvenCellSurface(right, {&left.distance}, {&bone.distance});
  ExpectClean(a);
  ExpectClean(b);
  EXPECT_TRUE(IntersectMeshes(SearchableMesh(a), SearchableMesh(b)).IsEmpty());
  EXPECT_TRUE(IntersectMeshes(SearchableMesh(a), bone.mesh).IsEmpty());
  EXPECT_TRUE(IntersectMeshes(SearchableMesh(b), bone.mesh).IsEmpty());
}

TEST(CellSurface, KeepsTheLargerPartOfAMuscleThatABoneCuts) {
  const Solid muscle(Spindle(8, 40, 4));
  const Solid plate(MovedBy(Box(60, 60, 4), {0, 0, 15}));
  const TriangleSoup surface = EvenCellSurface(muscle, {}, {&plate.distance});
  ExpectClean(surface);
  EXPECT_LT(surface.points.col(2).maxCoeff(), 13);
  EXPECT_LT(surface.points.col(2).minCoeff(), -37);
}

TEST(CellSurface, HasTrianglesOfTheSizeOfTheOldOnes) {
  const TriangleSoup sphere = Icosphere(10, 2);
  const Solid muscle(sphere);
  const TriangleSoup surface = EvenCellSurface(muscle, {}, {});
  ExpectClean(surface);
  const double old = TypicalEdge(sphere.points, sphere.triangles);
  ASSERT_GT(old, SurfaceOptions().spacing);
  // Edges come out up to a fifth longer or shorter than remeshing is asked for.
  EXPECT_NEAR(TypicalEdge(surface.points, surface.triangles), old, 0.2 * old);
}

TEST(CellSurface, IsEmptyIfNothingOfTheMuscleIsLeft) {
  const Solid muscle(Icosphere(5, 3));
  const Solid bone(Box(30, 30, 30));
  const TriangleSoup surface =
      CellSurface(SurfaceOptions(), muscle.distance, {}, {&bone.distance});
  EXPECT_EQ(surface.points.rows(), 0);
  EXPECT_EQ(surface.triangles.rows(), 0);
}

TEST(CellSurfaceOptions, NameWhatIsWrong) {
  ExpectValid(CellSurfaceOptions());
  ExpectRefused<CellSurfaceOptions>(
      [](auto* options) { options->spacing = 0; },
      "CellSurfaceOptions::spacing is 0, allowed: above 0");
  ExpectRefused<CellSurfaceOptions>(
      [](auto* options) { options->cell.voxel_size = 0; },
      "MedialCellOptions::voxel_size is 0, allowed: above 0");
}

}  // namespace musclewarp
