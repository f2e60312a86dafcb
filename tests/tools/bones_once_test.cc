// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "musclewarp/base/output_file.h"
#include "tools/motion_program.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using ::testing::HasSubstr;

// Returns what is in the files of a frame of the run in `dir`, by name.
std::map<std::string, std::string> FrameContents(const std::string& dir) {
  std::map<std::string, std::string> contents;
  for (const auto& entry : fs::directory_iterator(dir + "/frame_0006")) {
    contents[entry.path().filename()] = FileText(entry.path().string());
  }
  return contents;
}

// Returns the figures of musclewarp-check for a frame of the run in `dir`, with
// the names of the files without the folder.
Json FiguresOf(const std::string& dir) {
  const std::string frame = dir + "/frame_0006", json = dir + "/check.json";
  const ProgramRun check = RunCommandLine(
      MUSCLEWARP_CHECK, "--bone=thigh,shank --json=" + json + " " + frame);
  EXPECT_EQ(check.exit_code, 0) << check.errors;
  std::string text = FileText(json);
  fs::remove(json);
  for (size_t at; (at = text.find(frame)) != std::string::npos;) {
    text.erase(at, frame.size());
  }
  return Json::parse(text);
}

// The two runs, in which the shank turns.
class BonesOnce : public MotionProgram {
 protected:
  std::string every() const { return dir_ + "/every"; }
  std::string once() const { return dir_ + "/once"; }

  ProgramRun RunInto(const std::string& folder, const std::string& flags) {
    return RunCommandLine(MUSCLEWARP_DEFORM, Arguments(flags, folder));
  }
};

TEST_F(BonesOnce, LeaveTheMeshesOfBonesOutOfFrames) {
  ASSERT_EQ(RunInto(every(), "--frames=6").exit_code, 0);
  const ProgramRun run = RunInto(once(), "--frames=6 --bones=once");
  ASSERT_EQ(run.exit_code, 0) << run.out << run.errors;
  auto files = FrameContents(every());
  EXPECT_EQ(files.erase("shank.ply") + files.erase("thigh.ply"), 2u);
  EXPECT_EQ(files.count("bones.json"), 0u);
  auto files_once = FrameContents(once());
  const Json bones = Json::parse(files_once["bones.json"]);
  EXPECT_EQ(files_once.erase("bones.json"), 1u);
  EXPECT_EQ(files_once, files);
  EXPECT_EQ(bones["units"], "mm");
  EXPECT_EQ(bones["bones"].size(), 2u);
  EXPECT_NEAR(bones["bones"]["shank"][0][0], std::cos(M_PI / 6), 1e-12);
  EXPECT_EQ(bones["bones"]["shank"][3], Json({0, 0, 0, 1}));
}

TEST_F(BonesOnce, CheckFindsTheSame) {
  ASSERT_EQ(RunInto(every(), "--frames=6 --format=ply,obj").exit_code, 0);
  ASSERT_EQ(
      RunInto(once(), "--frames=6 --format=ply,obj --bones=once").exit_code, 0);
  const Json figures = FiguresOf(every());
  EXPECT_EQ(figures["files"].size(), 3u);
  EXPECT_EQ(FiguresOf(once()), figures);
}

TEST_F(BonesOnce, AnInterruptedRunGoesOnWithTheSameValueOnly) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer must be the first library that is loaded";
#endif
  ASSERT_EQ(RunInto(every(), "--frames=0:6:6 --bones=once").exit_code, 0);
  RunCommandLine(
      "MUSCLEWARP_KILL_BEFORE_RENAME=/frame_0006 "
      "LD_PRELOAD=" MUSCLEWARP_KILL_AT_FILE_CHANGE " " MUSCLEWARP_DEFORM,
      Arguments("--frames=0:6:6 --bones=once", once()));
  ASSERT_TRUE(fs::exists(once() + "/frame_0000"));
  ASSERT_FALSE(fs::exists(once() + "/frame_0006"));
  ProgramRun run = RunInto(once(), "--frames=0:6:6 --bones=every --resume");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.errors, HasSubstr("other input or options"));
  run = RunInto(once(), "--frames=0:6:6 --bones=once --resume");
  EXPECT_EQ(run.exit_code, 0) << run.out << run.errors;
  EXPECT_EQ(FrameContents(once()), FrameContents(every()));
}

TEST_F(BonesOnce, ValuesThatCannotBeAreRefused) {
  const auto refused = [&](const std::string& flags, const std::string& words) {
    const ProgramRun run = Run(flags);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_THAT(run.errors, HasSubstr(words));
    EXPECT_FALSE(fs::exists(out()));
  };
  refused("--bones=twice",
          "--bones=twice: is none of its values; allowed: every, once");
  refused("--bones=twice", "allowed: every, once");
#ifdef MUSCLEWARP_WITH_VTK
  refused("--bones=once --format=vtp", "add ply or obj");
#endif
}

#ifdef MUSCLEWARP_WITH_VTK
TEST_F(BonesOnce, ParaViewHasThemInEveryFrame) {
  const ProgramRun run =
      RunInto(once(), "--frames=6 --format=ply,vtp --bones=once");
  ASSERT_EQ(run.exit_code, 0) << run.out << run.errors;
  EXPECT_TRUE(fs::exists(once() + "/frame_0006/shank.vtp"));
  EXPECT_FALSE(fs::exists(once() + "/frame_0006/shank.ply"));
  EXPECT_THAT(FileText(once() + "/motion.pvd"),
              HasSubstr("frame_0006/shank.vtp"));
}
#endif

}  // namespace
}  // namespace musclewarp
