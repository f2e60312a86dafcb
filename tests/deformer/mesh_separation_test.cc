// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/deformer/mesh_separation.h"

#include <gtest/gtest.h>

#include "support/small_scene.h"

namespace musclewarp {
namespace {

// Two muscles without lines, one 4 mm deep in the other.
Scene OverlappingMeshes() {
  Scene scene = SmallScene();
  for (SceneMuscle& muscle : scene.muscles) muscle.lines.clear();
  scene.muscles[1].points.col(0).array() -= 4;
  return scene;
}

RestSeparationOptions WithSmallHulls() {
  RestSeparationOptions options = MeshSeparationOptions();
  options.prepare.muscle.hull.coarse_vertices = 60;
  return options;
}

}  // namespace

TEST(SeparateMeshes, LeavesNothingThatCrosses) {
  const MeshSeparation result =
      SeparateMeshes(OverlappingMeshes(), WithSmallHulls(), {});
  EXPECT_GT(result.before.triangle_pairs, 0);
  EXPECT_TRUE(result.frame.intersections.IsClean());
  EXPECT_TRUE(result.frame.IsUsable()) << result.frame.FullReport();
  EXPECT_GE(*result.frame.intersections.SmallestGap(), StepOptions().gap);
  EXPECT_TRUE(result.rest.reconstructed.empty());
}

// The frame is the separated rest pose itself, and no further solve.
TEST(SeparateMeshes, ReturnsTheSeparatedRestPose) {
  const MeshSeparation result =
      SeparateMeshes(OverlappingMeshes(), WithSmallHulls(), {});
  for (size_t i = 0; i < result.frame.muscles.size(); ++i) {
    EXPECT_EQ(result.frame.muscles[i].points, result.rest.state.points[i]);
    EXPECT_EQ(result.frame.muscles[i].solver.iterations, 0);
    EXPECT_TRUE(result.scene.muscles[i].model.lines.empty());
  }
}

TEST(SeparateMeshes, LeavesMeshesThatAreApartWhereTheyAre) {
  Scene scene = OverlappingMeshes();
  scene.muscles[1].points.col(0).array() += 20;
  const MeshSeparation result = SeparateMeshes(scene, WithSmallHulls(), {});
  EXPECT_EQ(result.before.triangle_pairs, 0);
  for (const MuscleFrame& muscle : result.frame.muscles) {
    EXPECT_LT(muscle.max_displacement, 1e-9);  // rounding, mm
  }
}

}  // namespace musclewarp
