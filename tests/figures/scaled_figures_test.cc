// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/figures/scaled_figures.h"

#include <gtest/gtest.h>

#include "figures/some_figures.h"

namespace musclewarp {
namespace {

TEST(ScaleFigures, FollowsTheUnits) {
  const FrameFigures before = SomeFigures(1);
  FrameFigures after = before;
  ScaleFigures(2, &after);
  const MuscleFigures& muscle = after.muscles[0];
  EXPECT_EQ(muscle.volume, 8 * before.muscles[0].volume);
  EXPECT_EQ(muscle.volume_ratio, before.muscles[0].volume_ratio);
  EXPECT_EQ(muscle.min_gap, 2 * before.muscles[0].min_gap);
  EXPECT_EQ(muscle.solver.final_energy, 16);
  EXPECT_EQ(muscle.solver.iterations, 17);
  EXPECT_EQ(muscle.shape.max_bend, before.muscles[0].shape.max_bend);
  EXPECT_EQ(muscle.shape.triangles.largest_patch, 14);
  EXPECT_EQ(muscle.line_lengths.at("l"), 202);
  EXPECT_EQ(muscle.line_moment_arms.at("l").at("hip"), 2 * (20.0 / 3));
  EXPECT_EQ(after.wall_ms, before.wall_ms);
  EXPECT_EQ(after.coordinates, before.coordinates);
  EXPECT_EQ(after.intersections.gaps[1].at_most_mm, 0.8);
  EXPECT_EQ(after.bone_overlaps[0].place, 2 * before.bone_overlaps[0].place);
}

// There and back by a power of two changes no bit, so that nothing is scaled
// one way only.
TEST(ScaleFigures, IsExactForPowersOfTwo) {
  const FrameFigures before = SomeFigures(1);
  FrameFigures figures = before;
  ScaleFigures(1.0 / 32, &figures);
  EXPECT_FALSE(AreEqual(figures, before));
  ScaleFigures(32, &figures);
  EXPECT_TRUE(AreEqual(figures, before));
}

TEST(ScaleFigures, OfIntersectionsIncludesGapsAndPlaces) {
  SceneIntersections intersections = SomeFigures(1).intersections;
  intersections.pairs[0].place << 1, 2, 3;
  ScaleFigures(2, &intersections);
  EXPECT_EQ(intersections.gaps[0].place, Eigen::RowVector3d(2, 4, 6));
  EXPECT_EQ(intersections.pairs[0].place, Eigen::RowVector3d(2, 4, 6));
  EXPECT_EQ(intersections.max_depth_mm, 0.6);
}

}  // namespace
}  // namespace musclewarp
