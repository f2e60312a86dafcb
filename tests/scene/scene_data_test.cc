// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "musclewarp/scene/scene.h"
#include "support/data_root.h"

namespace musclewarp {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

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

// Models as OpenSim Creator writes them, and a motion in degrees that says it
// is in radians.
TEST(SceneDataTest, CasesOfNamesAndUnitsReadWithAWord) {
  const std::string root = DataRoot();
  if (root.empty()) GTEST_SKIP() << kNoDataRoot;
  const Scene names =
      ReadScene(root + "/cases/coordinates_of_one_name/scene.json", "");
  EXPECT_EQ(names.poses.size(), 3u);
  EXPECT_THAT(names.warnings, Not(Contains(HasSubstr("elbow_flex"))));
  const Scene degrees =
      ReadScene(root + "/cases/degrees_called_radians/scene.json", "");
  EXPECT_THAT(degrees.warnings,
              Contains(HasSubstr("elbow_flex goes to 60 rad = 3438 degrees")));
}

}  // namespace musclewarp
