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

#include "musclewarp/base/angles.h"
#include "musclewarp/base/input_error.h"
#include "musclewarp/deformer/deformer.h"
#include "support/meshes.h"
#include "support/small_scene.h"

namespace musclewarp {
namespace {

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
  std::cout << AnswerOf(scene, FlexedPose(0.1)) << "\n";
}

TEST(OddScenes, MusclesThatAreFlat) {
  std::cout << AnswerOf(WithMuscle(MovedBy(Box(0, 20, 110), kLeft)),
                        FlexedPose(0.1))
            << "\n";
  std::cout << AnswerOf(WithMuscle(MovedBy(Box(0.01, 20, 110), kLeft)),
                        FlexedPose(0.1))
            << "\n";
}

TEST(OddScenes, ANeedle) {
  std::cout << AnswerOf(WithMuscle(MovedBy(Box(0.05, 0.05, 112), kLeft)),
                        FlexedPose(0.1))
            << "\n";
}

TEST(OddScenes, EqualMusclesInOnePlace) {
  Scene scene = SmallScene();
  scene.muscles[1].points = scene.muscles[0].points;
  std::cout << AnswerOf(scene, FlexedPose(0.1)) << "\n";
}

TEST(OddScenes, AMuscleInABone) {
  std::cout << AnswerOf(WithBone("cage", Icosphere(100, 3)), FlexedPose(0.1))
            << "\n";
}

TEST(OddScenes, ABoneInAMuscle) {
  std::cout << AnswerOf(WithBone("stone", SphereAt(kLeft, 4, 2)),
                        FlexedPose(0.1))
            << "\n";
}

TEST(OddScenes, MusclesThatShareAFace) {
  Scene scene = WithMuscle(MovedBy(Box(20, 20, 100), {-10, 0, 0}));
  const TriangleSoup other = MovedBy(Box(20, 20, 100), {10, 0, 0});
  scene.muscles[1].points = other.points;
  scene.muscles[1].triangles = other.triangles;
  std::cout << AnswerOf(scene, FlexedPose(0.1)) << "\n";
}

TEST(OddScenes, LinesThatAreEqual) {
  Scene scene = SmallScene();
  scene.muscles[0].lines.push_back(scene.muscles[0].lines[0]);
  scene.muscles[0].lines[1].name = "again";
  std::cout << AnswerOf(scene, FlexedPose(0.1)) << "\n";
}

TEST(OddScenes, ALineOutside) {
  Scene scene = SmallScene();
  scene.muscles[0].lines[0].rest.col(0).array() -= 300;
  std::cout << AnswerOf(scene, FlexedPose(0.1)) << "\n";
}

TEST(OddScenes, ALineWithoutLength) {
  Scene scene = SmallScene();
  scene.muscles[0].lines[0].rest.col(2) *= 1e-11;
  std::cout << AnswerOf(scene, FlexedPose(0.1)) << "\n";
}

TEST(OddScenes, NoMotion) {
  std::cout << AnswerOf(SmallScene(), FlexedPose(0)) << "\n";
}

TEST(OddScenes, HalfATurnInOneFrame) {
  std::cout << AnswerOf(SmallScene(), FlexedPose(RadiansOf(180))) << "\n";
}

TEST(OddScenes, ABoneThrownFar) {
  ScenePose pose = FlexedPose(0);
  pose.bodies["femur"](0, 3) = 1000;
  std::cout << AnswerOf(SmallScene(), pose) << "\n";
}

TEST(OddScenes, PosesThatAreNotRigid) {
  ScenePose mirrored = FlexedPose(0);
  mirrored.bodies["femur"](0, 0) = -1;
  std::cout << AnswerOf(SmallScene(), mirrored) << "\n";
  ScenePose sheared = FlexedPose(0);
  sheared.bodies["femur"](0, 1) = 0.1;
  std::cout << AnswerOf(SmallScene(), sheared) << "\n";
}

}  // namespace
}  // namespace musclewarp
