// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "benchmarks/step_replay.h"
#include "musclewarp/program/flags.h"
#include "musclewarp/settings/deformer_settings.h"
#include "musclewarp/settings/scene_settings.h"
#include "support/temp_dir.h"
#include "tools/run_program.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

// The second pose of the embedded motion; flags that come later win.
ProgramRun DeformOneFrame(const std::string& flags) {
  return RunCommandLine(MUSCLEWARP_DEFORM,
                        "--scene=" MUSCLEWARP_DATA_DIR
                        "/phantom/motion.json --frames=1 " +
                            flags);
}

// The files of the frames and what is in them.
std::map<std::string, std::string> FrameFiles(const std::string& out) {
  std::map<std::string, std::string> texts;
  for (const auto& entry : fs::recursive_directory_iterator(out)) {
    const std::string file = fs::relative(entry.path(), out).string();
    if (entry.is_regular_file() && file.rfind("frame_", 0) == 0) {
      texts[file] = FileText(entry.path().string());
    }
  }
  return texts;
}

// The first step of the rest pose, and all of the frame.
std::vector<std::string> StepFiles(const std::string& folder) {
  std::vector<std::string> files = {folder + "/rest_step_01.step"};
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().filename().string().rfind("frame_0001_step_", 0) == 0) {
      files.push_back(entry.path().string());
    }
  }
  return files;
}

// The flags that step_benchmark reads.
struct ReplayFlags {
  SceneSettings scene;
  DeformerSettings deformer;

  ReplayFlags() {
    RegisterFlags(&scene);
    RegisterFlags(&deformer);
  }
};

// The scene as the flags have it that are kept beside the steps, prepared as it
// was then.
StepReplay ReplayOf(const std::string& folder) {
  static ReplayFlags& flags = *new ReplayFlags;
  EXPECT_NE(
      gflags::SetCommandLineOption("flagfile", (folder + "/flags").c_str()),
      "");
  flags.deformer.given = GivenFlags();
  DeformerOptions options = OptionsOf(flags.deformer);
  options.cache.folder = folder + "/preparations";
  return StepReplay(
      ReadScene(
          flags.scene.scene, flags.scene.data_root, OptionsOf(flags.scene)),
      options);
}

TEST(RecordSteps, StepsEndAsRecordedAndFramesAreTheSameWithoutThem) {
  const std::string dir = TestTempDir();
  const std::string steps = dir + "/steps";
  ProgramRun run =
      DeformOneFrame("--record_steps=" + steps + " --out=" + dir + "/with");
  ASSERT_EQ(run.exit_code, 0) << run.out << run.errors;
  run = DeformOneFrame("--out=" + dir + "/without");
  ASSERT_EQ(run.exit_code, 0) << run.out << run.errors;
  const auto without = FrameFiles(dir + "/without");
  EXPECT_GT(without.size(), 0u);
  EXPECT_EQ(FrameFiles(dir + "/with"), without);

  const std::vector<std::string> files = StepFiles(steps);
  EXPECT_GE(files.size(), 2u);
  const StepReplay replay = ReplayOf(steps);
  for (const std::string& file : files) {
    StepDifference difference;
    difference.is_same = false;
    replay.Take(file, ReadRecordedStep(file), 2, 1, &difference);
    EXPECT_TRUE(difference.is_same)
        << file << ": points differ by " << difference.points << " mm";
  }
}

TEST(RecordSteps, AreRefusedWithoutCertifiedContactBeforeAnythingIsWritten) {
  const std::string dir = TestTempDir();
  const ProgramRun run = DeformOneFrame("--contact=none --record_steps=" + dir +
                                        "/steps --out=" + dir + "/out");
  EXPECT_EQ(run.exit_code, 2) << run.out;
  EXPECT_THAT(run.errors,
              AllOf(HasSubstr("--record_steps"), HasSubstr("--contact=none")));
  EXPECT_TRUE(fs::is_empty(dir));
}

}  // namespace
}  // namespace musclewarp
