// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frame_solvers/paper_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/meshes.h"
#include "support/prepared_small_scene.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// A scene of muscles and a bone as they are; without solves nothing else of
// them matters.
PreparedScene SceneOf(const std::vector<TriangleSoup>& muscles,
                      const TriangleSoup& bone) {
  PreparedScene scene;
  for (size_t i = 0; i < muscles.size(); ++i) {
    PreparedMuscle& muscle = scene.muscles.emplace_back();
    muscle.model.name = std::string(1, static_cast<char>('a' + i));
    muscle.model.fine_rest = muscles[i].points;
    muscle.model.fine_triangles = muscles[i].triangles;
  }
  PreparedBone& prepared = scene.bones.emplace_back();
  prepared.mesh.name = prepared.body = "bone";
  prepared.rest = bone;
  return scene;
}

std::vector<std::string> WarningsOf(const std::vector<TriangleSoup>& muscles,
                                    const TriangleSoup& bone) {
  PaperSceneOptions options;
  options.group.level = ContactLevel::kFine;
  return PreparePaperScene(SceneOf(muscles, bone), options).warnings;
}

const TriangleSoup& Far() {
  static const auto* far = new TriangleSoup(SphereAt({100, 0, 0}, 5, 1));
  return *far;
}

TEST(PaperScene, WarnsOfMeshesThatNothingParts) {
  const TriangleSoup ball = Icosphere(10, 2);
  EXPECT_THAT(WarningsOf({ball, ball}, Far()),
              ElementsAre("a and b are the same mesh: nothing parts them"));
  EXPECT_THAT(WarningsOf({ball, Far()}, ball),
              ElementsAre("a and bone are the same mesh: nothing parts them"));
}

TEST(PaperScene, WarnsOfMeshesInsideOthers) {
  const TriangleSoup ball = Icosphere(10, 2), inner = Icosphere(8, 2);
  EXPECT_THAT(WarningsOf({inner, ball}, Far()), ElementsAre("a lies inside b"));
  EXPECT_THAT(WarningsOf({ball, inner}, Far()), ElementsAre("b lies inside a"));
  EXPECT_THAT(WarningsOf({ball}, inner), ElementsAre("bone lies inside a"));
  EXPECT_THAT(WarningsOf({inner}, ball), ElementsAre("a lies inside bone"));
}

// Overlapping is what contact is for.
TEST(PaperScene, HasNothingToSayOfMeshesThatOverlap) {
  EXPECT_THAT(WarningsOf({Icosphere(10, 2), SphereAt({9, 0, 0}, 8, 2)}, Far()),
              IsEmpty());
}

TEST(PaperScene, HasHullsOnlyIfContactIsSolvedForThem) {
  const PreparedScene scene = PreparedSmallScene();
  PaperSceneOptions options;
  options.group.level = ContactLevel::kFine;
  const PaperScene fine = PreparePaperScene(scene, options);
  EXPECT_EQ(fine.muscles.size(), 2u);
  EXPECT_EQ(fine.bones.size(), 2u);
  EXPECT_TRUE(fine.muscle_hulls.empty() && fine.bone_hulls.empty());
  options.group.level = ContactLevel::kCoarse;
  const PaperScene coarse = PreparePaperScene(scene, options);
  EXPECT_EQ(coarse.muscle_hulls.size(), 2u);
  EXPECT_EQ(coarse.bone_hulls.size(), 2u);
  EXPECT_EQ(coarse.muscle_hulls[1]->rest, scene.muscles[1].model.coarse_rest);
}

}  // namespace
}  // namespace musclewarp
