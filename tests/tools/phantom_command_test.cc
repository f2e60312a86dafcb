// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/phantom_command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <sstream>
#include <string>

#include "musclewarp/base/input_error.h"
#include "musclewarp/scene/scene.h"
#include "support/temp_dir.h"
#include "tools/run_program.h"

namespace musclewarp {
namespace {

std::string PhantomError(const PhantomRequest& request) {
  std::ostringstream log;
  try {
    MakePhantom(request, log);
  } catch (const InputError& error) {
    return error.WithFlags();
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
  EXPECT_THAT(PhantomError({}), ::testing::HasSubstr("--out"));
}

TEST(MakePhantom, AWrongSceneWritesNothing) {
  PhantomRequest request;
  request.out = TestTempDir() + "/knee";
  request.scene = "knee";
  EXPECT_THAT(PhantomError(request), ::testing::HasSubstr("knee"));
  EXPECT_FALSE(std::filesystem::exists(request.out));
}

// File contents by name.
std::map<std::string, std::string> FilesIn(const std::string& dir) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(dir)) {
    files[entry.path().filename().string()] = FileText(entry.path().string());
  }
  return files;
}

TEST(MakePhantom, ARandomSceneHasTheSameBytesForTheSameSeed) {
  PhantomRequest request;
  request.scene = "random";
  request.seed = 9;
  request.num_muscles = 2;
  const std::string dir = TestTempDir();
  std::ostringstream log;
  for (const std::string name : {"one", "other"}) {
    request.out = dir + "/" + name;
    MakePhantom(request, log);
  }
  const auto one = FilesIn(dir + "/one");
  EXPECT_TRUE(one == FilesIn(dir + "/other"));
  const Scene scene = ReadScene(request.out + "/scene.json", "");
  EXPECT_EQ(scene.muscles.size(), 2u);
  EXPECT_EQ(one.size(), 1 + scene.muscles.size() + scene.bones.size());
  EXPECT_TRUE(scene.is_motion);
}

TEST(MakePhantom, ABadNumberOfMusclesWritesNothing) {
  PhantomRequest request;
  request.out = TestTempDir() + "/random";
  request.scene = "random";
  request.num_muscles = 33;
  EXPECT_THAT(PhantomError(request), ::testing::HasSubstr("--num_muscles"));
  request.scene = "hip";
  request.num_muscles = 3;
  EXPECT_THAT(PhantomError(request), ::testing::HasSubstr("--num_muscles"));
  EXPECT_FALSE(std::filesystem::exists(request.out));
}

TEST(PhantomProgram, BadFlagsAreRefusedByName) {
  const std::string out = " --out=" + TestTempDir() + "/scene";
  for (const std::string flag :
       {"--num_muscles=1", "--num_muscles=-2", "--num_muscles=many"}) {
    const ProgramRun run =
        RunCommandLine(MUSCLEWARP_PHANTOM, "--scene=random " + flag + out);
    EXPECT_EQ(run.exit_code, 2) << flag;
    EXPECT_THAT(run.errors, ::testing::HasSubstr("num_muscles")) << flag;
  }
  const ProgramRun run =
      RunCommandLine(MUSCLEWARP_PHANTOM, "--scene=random --seed=-1" + out);
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.errors, ::testing::HasSubstr("seed"));
}

}  // namespace
}  // namespace musclewarp
