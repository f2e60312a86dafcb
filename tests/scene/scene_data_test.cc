// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "musclewarp/scene/scene.h"
#include "support/data_root.h"

namespace musclewarp {

TEST(SceneDataTest, EveryDeliveredSceneReads) {
  const std::string root = DataRoot();
  if (root.empty()) GTEST_SKIP() << kNoDataRoot;
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
