// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
//
// Scenes that no anatomy has, but damaged data do. Each has a clear answer: a
// refusal, a usable frame whose certificate holds, or a frame that says why it
// is not usable.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <string>
#include <tuple>

#include "musclewarp/base/angles.h"
#include "musclewarp/base/input_error.h"
#include "musclewarp/deformer/deformer.h"
#include "support/meshes.h"
#include "support/small_scene.h"

namespace musclewarp {
namespace {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

// Returns "refused: ...", "usable" or "not usable: ..." of a pose, and checks
// that nothing which is not finite comes out.
std::string AnswerOf(const Scene& scene, const ScenePose& pose) {
  DeformerOptions options;
  options.prepare.muscle.hull.coarse_vertices = 60;
  try {
    Deformer deformer(scene, options);
    const Frame frame = deformer.MoveTo(pose);
    for (const MuscleFrame& muscle : frame.muscles) {
      EXPECT_TRUE(muscle.points.allFinite()) << muscle.name;
    }
    if (frame.IsUsable()) {
      EXPECT_TRUE(frame.intersections.IsClean());
      return "usable";
    }
    std::string answer = "not usable:";
    for (const std::string& text : frame.shortcomings) answer += " " + text;
    return answer;
  } catch (const InputError& error) {
    return std::string("refused: ") + error.what();
  }
}

// The small scene with another mesh for its left muscle.
Scene WithMuscle(const TriangleSoup& mesh) {
  Scene scene = SmallScene();
  scene.muscles[0].points = mesh.points;
  scene.muscles[0].triangles = mesh.triangles;
  return scene;
}

Scene WithBone(const std::string& name, const TriangleSoup& mesh) {
  Scene scene = SmallScene();
  scene.bones.push_back({name, mesh.points, mesh.triangles, "femur"});
  return scene;
}

const Eigen::RowVector3d kLeft(-12.5, 0, 0);

TEST(OddScenes, AMuscleOfFourVertices) {
  TriangleSoup mesh = UnitTetrahedron();
  mesh.points *= 40;
  const Scene scene = WithMuscle(MovedBy(mesh, {-45, -5, -5}));
  EXPECT_EQ(AnswerOf(scene, FlexedPose(0.1)), "usable");
}

TEST(OddScenes, MusclesThatAreFlat) {
  const auto answer_of = [](double thickness) {
    const TriangleSoup mesh = MovedBy(Box(thickness, 20, 110), kLeft);
    return AnswerOf(WithMuscle(mesh), FlexedPose(0.1));
  };
  EXPECT_THAT(answer_of(0),
              AllOf(StartsWith("refused: left"), HasSubstr("holds 0 mm3")));
  EXPECT_THAT(answer_of(0.01), StartsWith("not usable: left: "));
}

TEST(OddScenes, ANeedle) {
  const TriangleSoup needle = MovedBy(Box(0.05, 0.05, 112), kLeft);
  EXPECT_THAT(AnswerOf(WithMuscle(needle), FlexedPose(0.02)),
              AnyOf(StartsWith("not usable: left: "), "usable"));
}

TEST(OddScenes, EqualMusclesInOnePlace) {
  Scene scene = SmallScene();
  scene.muscles[1].points = scene.muscles[0].points;
  EXPECT_THAT(AnswerOf(scene, FlexedPose(0.1)),
              AllOf(StartsWith("refused: left"), HasSubstr("lies outside")));
}

TEST(OddScenes, AMuscleInABone) {
  EXPECT_THAT(AnswerOf(WithBone("cage", Icosphere(100, 3)), FlexedPose(0.1)),
              AllOf(StartsWith("refused: left"), HasSubstr("lies outside")));
}

TEST(OddScenes, ABoneInAMuscle) {
  const Scene scene = WithBone("stone", SphereAt(kLeft, 4, 2));
  EXPECT_THAT(AnswerOf(scene, FlexedPose(0.1)),
              AllOf(StartsWith("refused: "), HasSubstr("left crosses stone")));
}

TEST(OddScenes, MusclesThatShareAFace) {
  Scene scene = WithMuscle(MovedBy(Box(20, 20, 100), {-10, 0, 0}));
  const TriangleSoup other = MovedBy(Box(20, 20, 100), {10, 0, 0});
  scene.muscles[1].points = other.points;
  scene.muscles[1].triangles = other.triangles;
  EXPECT_EQ(AnswerOf(scene, FlexedPose(0.1)), "usable");
}

TEST(OddScenes, LinesThatAreEqual) {
  Scene scene = SmallScene();
  scene.muscles[0].lines.push_back(scene.muscles[0].lines[0]);
  scene.muscles[0].lines[1].name = "again";
  EXPECT_EQ(AnswerOf(scene, FlexedPose(0.1)), "usable");
}

TEST(OddScenes, ALineOutside) {
  Scene scene = SmallScene();
  scene.muscles[0].lines[0].rest.col(0).array() -= 300;
  EXPECT_EQ(AnswerOf(scene, FlexedPose(0.1)), "usable");
}

TEST(OddScenes, ALineWithoutLength) {
  Scene scene = SmallScene();
  scene.muscles[0].lines[0].rest.col(2) *= 1e-11;  // 1e-9 mm are left
  EXPECT_EQ(AnswerOf(scene, FlexedPose(0.1)), "usable");
}

TEST(OddScenes, NoMotion) {
  EXPECT_EQ(AnswerOf(SmallScene(), FlexedPose(0)), "usable");
}

TEST(OddScenes, HalfATurnInOneFrame) {
  EXPECT_THAT(AnswerOf(SmallScene(), FlexedPose(RadiansOf(180))),
              AllOf(StartsWith("not usable: "), HasSubstr("by contact")));
}

TEST(OddScenes, ABoneThrownFar) {
  ScenePose pose = FlexedPose(0);
  pose.bodies["femur"](0, 3) = 1000;
  EXPECT_THAT(AnswerOf(SmallScene(), pose), StartsWith("not usable: "));
}

TEST(OddScenes, PosesThatAreNotRigid) {
  for (const auto& [row, column, value] :
       {std::tuple(0, 0, -1.0), std::tuple(0, 1, 0.1)}) {
    ScenePose pose = FlexedPose(0);
    pose.bodies["femur"](row, column) = value;  // mirrored, sheared
    EXPECT_THAT(AnswerOf(SmallScene(), pose),
                AllOf(StartsWith("refused: "), HasSubstr("rigid motion")));
  }
}

}  // namespace
}  // namespace musclewarp
