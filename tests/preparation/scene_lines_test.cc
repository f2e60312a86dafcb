// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/scene_lines.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "support/meshes.h"
#include "support/small_scene.h"

namespace musclewarp {
namespace {

// The left muscle of the small scene without lines, and a bone "tibia" that is
// nearer to its upper tip, at (-12.5, 0, 60), than the femur: 3 mm beside it.
Scene SceneWithTwoBonesAbove() {
  Scene scene = SmallScene();
  scene.muscles.resize(1);
  scene.muscles[0].lines.clear();
  const TriangleSoup tibia = SphereAt({-12.5, 0, 71}, 10, 3);
  scene.bones.push_back({"tibia", tibia.points, tibia.triangles});
  return scene;
}

std::vector<ActionLine> LinesOf(const Scene& scene) {
  Surroundings surroundings;
  for (const SceneBone& bone : scene.bones) {
    surroundings.AddBone(bone.name, {bone.points, bone.triangles});
  }
  for (const SceneMuscle& muscle : scene.muscles) {
    surroundings.AddMuscle({muscle.points, muscle.triangles});
  }
  return MakeSceneLines(surroundings, {3, LineCourse::kTaut}, {}, scene)[0]
      .lines;
}

std::set<std::string> BodiesIn(const std::vector<ActionLine>& lines) {
  std::set<std::string> bodies;
  for (const ActionLine& line : lines) {
    bodies.insert(line.bodies.begin(), line.bodies.end());
  }
  return bodies;
}

TEST(MakeSceneLines, EndOnTheNearestBones) {
  EXPECT_EQ(BodiesIn(LinesOf(SceneWithTwoBonesAbove())),
            (std::set<std::string>{"pelvis", "tibia"}));
}

TEST(MakeSceneLines, EndOnTheBodiesThatTheMuscleNames) {
  Scene scene = SceneWithTwoBonesAbove();
  scene.muscles[0].end_bodies = {"pelvis", "femur"};
  const std::vector<ActionLine> lines = LinesOf(scene);
  EXPECT_EQ(BodiesIn(lines), (std::set<std::string>{"pelvis", "femur"}));
  for (const ActionLine& line : lines) {
    EXPECT_EQ(line.bodies.front(), "pelvis");
    EXPECT_EQ(line.bodies.back(), "femur");
  }
}

// Both tips are nearest to the same body of the two.
TEST(MakeSceneLines, EndOnBothBodiesHoweverFarTheyAre) {
  Scene scene = SceneWithTwoBonesAbove();
  scene.muscles[0].end_bodies = {"tibia", "femur"};
  for (const ActionLine& line : LinesOf(scene)) {
    EXPECT_NE(line.bodies.front(), line.bodies.back());
  }
}

}  // namespace
}  // namespace musclewarp
