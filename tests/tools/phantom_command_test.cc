// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/phantom_command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "musclewarp/base/input_error.h"
#include "musclewarp/scene/scene.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

std::string ErrorOf(const PhantomRequest& request) {
  std::ostringstream log;
  try {
    MakePhantom(request, log);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(MakePhantom, WritesASceneAndSaysWhatIsInIt) {
  PhantomRequest request;
  request.out = TestTempDir() + "/hip";
  std::ostringstream log;
  MakePhantom(request, log);
  const Scene scene = ReadScene(request.out + "/scene.json", "");
  for (const SceneMuscle& muscle : scene.muscles) {
    EXPECT_TRUE(std::filesystem::exists(muscle.mesh_path));
    EXPECT_THAT(log.str(), ::testing::HasSubstr(muscle.name));
  }
  EXPECT_THAT(log.str(), ::testing::HasSubstr("3 muscles, 2 bones, 5 poses"));
}

TEST(MakePhantom, NeedsAFolder) {
  EXPECT_THAT(ErrorOf({}), ::testing::HasSubstr("--out"));
}

TEST(MakePhantom, AWrongSceneWritesNothing) {
  PhantomRequest request;
  request.out = TestTempDir() + "/knee";
  request.scene = "knee";
  EXPECT_THAT(ErrorOf(request), ::testing::HasSubstr("knee"));
  EXPECT_FALSE(std::filesystem::exists(request.out));
}

}  // namespace
}  // namespace musclewarp
