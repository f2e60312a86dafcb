// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/phantom/phantom_scene.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/input_errors.h"

namespace musclewarp {
namespace {

TEST(PhantomScene, AWrongNameIsAnErrorThatNamesTheScenes) {
  std::vector<std::string> words = PhantomSceneNames();
  EXPECT_EQ(words[0], "hip");
  words.insert(words.begin(), "\"knee\"");
  ExpectInputError([] { MakePhantomScene("knee", 1); }, words);
}

TEST(PhantomScene, IsNamedAndHasAMeshForEverySurface) {
  const PhantomScene scene = MakePhantomScene("stress_sheet", 1);
  EXPECT_EQ(scene.scene.name, "stress_sheet");
  const auto& muscles = scene.scene.muscles;
  const auto& bones = scene.scene.bones;
  ASSERT_EQ(scene.meshes.size(), muscles.size() + bones.size());
  for (size_t i = 0; i < scene.meshes.size(); ++i) {
    EXPECT_EQ(
        scene.meshes[i].name,
        i < muscles.size() ? muscles[i].name : bones[i - muscles.size()].name);
  }
}

}  // namespace
}  // namespace musclewarp
