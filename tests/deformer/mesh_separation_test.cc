// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/deformer/mesh_separation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "musclewarp/proximity/mesh_intersection.h"
#include "support/meshes.h"
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

// A plate of 48 x 48 mm between two heights, mm.
TriangleSoup Plate(double bottom, double top) {
  TriangleSoup plate = LatticeBox(12, 12, 1);
  plate.points.leftCols(2) *= 4;
  plate.points.col(2) = bottom + (top - bottom) * plate.points.col(2).array();
  return plate;
}

// Three layers of 2 mm: the one in the middle has a wall in common with the one
// above and overlaps the one below by this, mm.
Scene ThreeLayers(double overlap) {
  Scene scene;
  const auto add = [&](const std::string& name, const TriangleSoup& soup) {
    SceneMuscle muscle;
    muscle.name = name;
    muscle.points = soup.points;
    muscle.triangles = soup.triangles;
    scene.muscles.push_back(muscle);
  };
  add("deep", Plate(overlap - 2, overlap));
  add("middle", Plate(0, 2));
  add("superficial", Plate(2, 4));
  return scene;
}

}  // namespace

// A muscle between two others is pushed by both, and its volume pushes them
// back: none moves by more than what the layers share, and the gaps. Without
// that the volume would grow out of the rim.
TEST(SeparateMeshes, LayersBetweenOthersMoveByTheirOverlap) {
  constexpr double kOverlap = 0.5;
  const double kGaps = 4 * StepOptions().gap;  // two of twice the gap
  const MeshSeparation result =
      SeparateMeshes(ThreeLayers(kOverlap), MeshSeparationOptions(), {});
  EXPECT_TRUE(result.frame.IsUsable()) << result.frame.FullReport();
  for (const MuscleFrame& muscle : result.frame.muscles) {
    EXPECT_LT(muscle.max_displacement, kOverlap + kGaps) << muscle.name;
    EXPECT_LT(std::abs(muscle.volume_error), 1e-6) << muscle.name;
  }
}

TEST(SeparateMeshes, MovesBeyondTheAllowanceAreShortcomings) {
  RestSeparationOptions options = WithSmallHulls();
  options.requirements.displacement_per_depth = 0;
  options.requirements.displacement_allowance = 0.1;
  const MeshSeparation result =
      SeparateMeshes(OverlappingMeshes(), options, {});
  EXPECT_TRUE(result.rest.reconstructed.empty());
  ASSERT_FALSE(result.frame.shortcomings.empty());
  EXPECT_NE(result.frame.shortcomings[0].find("mm deep without"),
            std::string::npos);
}

// A muscle along z and a bone of two balls, each 2 mm deep in it, and what else
// its mesh has.
Scene MuscleOnTwoBalls(const TriangleSoup& more) {
  Scene scene;
  const TriangleSoup spindle = Spindle(10, 60, 3);
  SceneMuscle muscle;
  muscle.name = "psoas";
  muscle.points = spindle.points;
  muscle.triangles = spindle.triangles;
  scene.muscles.push_back(muscle);
  const TriangleSoup balls = Together(
      Together(SphereAt({16, 0, -12}, 8, 3), SphereAt({15, 0, 20}, 7, 3)),
      more);
  scene.bones.push_back({"foot", balls.points, balls.triangles});
  return scene;
}

TEST(SeparateMeshes, NothingCrossesAnyPieceOfABoneAsDelivered) {
  const Scene scene = MuscleOnTwoBalls(SphereAt({-40, 0, 0}, 6, 2));
  const MeshSeparation result = SeparateMeshes(scene, WithSmallHulls(), {});
  EXPECT_TRUE(result.frame.IsUsable()) << result.frame.FullReport();
  EXPECT_EQ(result.scene.bones[0].mesh.repairs.pieces, 3);
  EXPECT_EQ(result.scene.bones[0].delivered_only.triangles.rows(), 0);
  const TriangleSoup delivered = {scene.bones[0].points,
                                  scene.bones[0].triangles};
  const TriangleSoup muscle = {result.frame.muscles[0].points,
                               scene.muscles[0].triangles};
  EXPECT_TRUE(IntersectMeshes(muscle, delivered).IsEmpty());
  EXPECT_GT(result.before.triangle_pairs, 0);
}

TEST(SeparateMeshes, ACrumbOfABoneWithinAMuscleIsAShortcoming) {
  const Scene scene = MuscleOnTwoBalls(SphereAt({0, 0, 0}, 0.2, 1));
  const MeshSeparation result = SeparateMeshes(scene, WithSmallHulls(), {});
  EXPECT_TRUE(result.frame.intersections.IsClean());
  ASSERT_EQ(result.frame.delivered_crossings.size(), 1u);
  EXPECT_EQ(result.frame.delivered_crossings[0].pieces_inside, 1);
  EXPECT_FALSE(result.frame.IsUsable());
  ASSERT_EQ(result.scene.warnings.size(), 1u);
  EXPECT_NE(result.scene.warnings[0].find("foot: 1 crumb"), std::string::npos)
      << result.scene.warnings[0];
}

TEST(SeparateMeshes, APieceThatAMuscleLosesIsAShortcoming) {
  Scene scene = MuscleOnTwoBalls(SphereAt({-40, 0, 0}, 6, 2));
  SceneMuscle& muscle = scene.muscles[0];
  const TriangleSoup both =
      Together({muscle.points, muscle.triangles}, SphereAt({0, 60, 0}, 12, 3));
  muscle.points = both.points;
  muscle.triangles = both.triangles;
  const MeshSeparation result = SeparateMeshes(scene, WithSmallHulls(), {});
  ASSERT_FALSE(result.frame.IsUsable());
  EXPECT_NE(result.frame.shortcomings[0].find("% of its volume"),
            std::string::npos)
      << result.frame.shortcomings[0];
}

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
