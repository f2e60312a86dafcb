// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/muscles_at_rest.h"

#include <gtest/gtest.h>

#include "support/input_errors.h"
#include "support/prepared_small_scene.h"

namespace musclewarp {
namespace {

// The small scene, of whose two muscles the second one has no lines.
Scene SceneWithoutALine() {
  Scene scene = SmallScene();
  for (SceneBone& bone : scene.bones) bone.body = bone.name;
  scene.muscles[1].lines.clear();
  return scene;
}

TEST(MusclesAtRest, HaveTheLinesAndVolumesThatAScenePreparesTo) {
  const Scene scene = SceneWithoutALine();
  const PreparedScene prepared = PreparedSmallScene(scene);
  const std::vector<MuscleAtRest> muscles = MusclesAtRest(scene, {});
  ASSERT_EQ(muscles.size(), 2u);
  EXPECT_EQ(muscles[0].lines.size(), 1u);
  EXPECT_EQ(muscles[1].lines.size(), 3u);  // PrepareOptions::auto_lines
  for (size_t m = 0; m < 2; ++m) {
    const std::vector<ActionLine>& expected = prepared.scene.muscles[m].lines;
    ASSERT_EQ(muscles[m].lines.size(), expected.size());
    for (size_t i = 0; i < expected.size(); ++i) {
      EXPECT_EQ(muscles[m].lines[i].name, expected[i].name);
      EXPECT_EQ(muscles[m].lines[i].rest, expected[i].rest);
      EXPECT_EQ(muscles[m].lines[i].bodies, expected[i].bodies);
    }
    EXPECT_EQ(muscles[m].volume, prepared.muscles[m].mesh.delivered_volume);
    EXPECT_GT(muscles[m].volume, 0);
  }
}

TEST(MusclesAtRest, RefuseAMuscleWithoutBones) {
  Scene scene = SceneWithoutALine();
  scene.bones.clear();
  ExpectInputError([&] { MusclesAtRest(scene, {}); }, {scene.muscles[1].name});
}

}  // namespace
}  // namespace musclewarp
