// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/phantom/demo_scene.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "musclewarp/base/input_file.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

TEST(DemoScene, IsTheOneOfTheSources) {
  const std::string dir = TestTempDir();
  WriteDemoScene(dir);
  ASSERT_TRUE(fs::exists(DemoScenePath(dir)));
  const fs::path folder = fs::path(DemoScenePath(dir)).parent_path();
  int files = 0;
  for (const fs::directory_entry& file : fs::directory_iterator(folder)) {
    const fs::path source =
        fs::path(MUSCLEWARP_EMBEDDED_DATA) / "phantom" / file.path().filename();
    EXPECT_EQ(ReadFile(file.path().string()), ReadFile(source.string()));
    ++files;
  }
  EXPECT_EQ(files, 9);
}

}  // namespace
}  // namespace musclewarp
