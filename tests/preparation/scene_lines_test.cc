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

// A muscle along z from 0 to 100 below its bone "femur", and from its lower end
// to the bone "foot" a tendon with a mesh of its own.
Scene SceneWithATendon() {
  Scene scene;
  const auto muscle = [&](const std::string& name, const TriangleSoup& mesh) {
    SceneMuscle& added = scene.muscles.emplace_back();
    added.name = name;
    added.points = mesh.points;
    added.triangles = mesh.triangles;
  };
  muscle("tendon", MovedBy(Spindle(4, 40, 4), {0, 0, -30}));
  muscle("muscle", MovedBy(Spindle(10, 50, 4), {0, 0, 50}));
  const TriangleSoup femur = SphereAt({0, 0, 107}, 10, 3);
  const TriangleSoup foot = SphereAt({0, 0, -77}, 10, 3);
  scene.bones.push_back({"femur", femur.points, femur.triangles});
  scene.bones.push_back({"foot", foot.points, foot.triangles});
  return scene;
}

std::vector<MadeLines> Made(const Scene& scene, LineCourse course) {
  Surroundings surroundings;
  for (const SceneBone& bone : scene.bones) {
    surroundings.AddBone(bone.name, bone.name, {bone.points, bone.triangles});
  }
  for (const SceneMuscle& muscle : scene.muscles) {
    surroundings.AddMuscle({muscle.points, muscle.triangles});
  }
  return MakeSceneLines(surroundings, {3, course}, {}, scene);
}

std::vector<ActionLine> LinesOf(const Scene& scene,
                                LineCourse course = LineCourse::kTaut) {
  return Made(scene, course)[0].lines;
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

TEST(MakeSceneLines, TendonsHaveTheLinesOfTheirMuscles) {
  const auto made = Made(SceneWithATendon(), LineCourse::kTaut);
  ASSERT_EQ(made[1].tied_to, std::vector<int>{0});
  EXPECT_EQ(made[0].through, std::vector<int>{1});
  ASSERT_EQ(made[0].lines.size(), made[1].lines.size());
  for (size_t k = 0; k < made[0].lines.size(); ++k) {
    EXPECT_EQ(made[0].lines[k].rest, made[1].lines[k].rest);
    EXPECT_EQ(made[0].lines[k].name, "tendon_" + std::to_string(k + 1));
    EXPECT_EQ(made[0].lines[k].supports->ties.size(),
              made[1].lines[k].supports->ties.size());
  }
  EXPECT_EQ(BodiesIn(made[0].lines), (std::set<std::string>{"femur", "foot"}));
}

TEST(MakeSceneLines, GuidedLinesHaveNinePointsAndNoSupports) {
  const auto made = Made(SceneWithATendon(), LineCourse::kGuided);
  EXPECT_EQ(BesideTendons(LineCourse::kGuided, {0}, {0}), std::vector<int>{0});
  EXPECT_TRUE(BesideTendons(LineCourse::kTaut, {0}, {0}).empty());
  for (const MadeLines& lines : made) {
    for (const ActionLine& line : lines.lines) EXPECT_FALSE(line.supports);
  }
  EXPECT_EQ(
      LinesOf(SceneWithTwoBonesAbove(), LineCourse::kGuided)[0].rest.rows(), 9);
}

// A line that slides in the scene keeps its points, and gets supports.
TEST(MakeSceneLines, SlidingLinesOfTheSceneAreTaut) {
  Scene scene = SceneWithTwoBonesAbove();
  ActionLine& line = scene.muscles[0].lines.emplace_back();
  line.name = "given";
  line.rest.resize(3, 3);
  line.rest << -12.5, 0, -60, -10, 0, 0, -12.5, 0, 60;
  line.bodies = {"pelvis", "pelvis", "femur"};
  EXPECT_FALSE(NeedsLines(scene, LineCourse::kTaut));
  line.slides = true;
  EXPECT_TRUE(NeedsLines(scene, LineCourse::kTaut));
  EXPECT_FALSE(NeedsLines(scene, LineCourse::kGuided));
  const auto made = Made(scene, LineCourse::kTaut);
  ASSERT_EQ(made[0].lines.size(), 1u);
  EXPECT_EQ(made[0].lines[0].rest, line.rest);
  EXPECT_GT(made[0].lines[0].supports->loads[1], 0);
  EXPECT_TRUE(Made(scene, LineCourse::kGuided)[0].lines.empty());
}

}  // namespace
}  // namespace musclewarp
