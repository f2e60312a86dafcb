// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "musclewarp/scene/scene.h"

namespace musclewarp {

TEST(SceneDataTest, EveryDeliveredSceneReads) {
  const char* root = std::getenv("MUSCLEWARP_DATA_ROOT");
  if (!root) GTEST_SKIP() << "MUSCLEWARP_DATA_ROOT is not set";
  int scenes = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(MUSCLEWARP_SCENES_DIR)) {
    const Scene scene = ReadScene(entry.path().string(), root);
    EXPECT_GE(scene.poses.size(), 4u) << entry.path();
    ++scenes;
  }
  EXPECT_GE(scenes, 2);
}

}  // namespace musclewarp
