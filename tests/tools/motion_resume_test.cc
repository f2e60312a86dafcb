// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <csignal>
#include <cstdio>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "musclewarp/base/output_file.h"
#include "tools/motion_program.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::HasSubstr;

// All files but report.json, whose times differ, by name below `dir`.
std::map<std::string, std::string> Contents(const std::string& dir) {
  std::map<std::string, std::string> contents;
  for (const auto& entry : fs::recursive_directory_iterator(dir)) {
    if (!entry.is_regular_file()) continue;
    const std::string name = fs::relative(entry.path(), dir).string();
    if (name != "report.json") contents[name] = FileText(entry.path().string());
  }
  return contents;
}

std::set<std::string> Names(const std::map<std::string, std::string>& files) {
  std::set<std::string> names;
  for (const auto& [name, bytes] : files) names.insert(name);
  return names;
}

// The report without times and without the command line, which differ from run
// to run, and without "cached": a run that goes on reads its preparation.
Json WithoutTimes(Json report) {
  if (report.is_object()) {
    report.erase("command");
    report.erase("options");
    report.erase("cached");
  }
  if (report.is_structured()) {
    for (auto item = report.begin(); item != report.end();) {
      const bool is_time =
          report.is_object() && (item.key().find("_ms") != std::string::npos);
      if (is_time) {
        item = report.erase(item);
      } else {
        if (item->is_structured()) *item = WithoutTimes(*item);
        ++item;
      }
    }
  }
  return report;
}

// A place in a run of frames 0 and 6 where it is killed: a variable that
// kill_at_file_change.cc reads, and its value.
struct Kill {
  const char* when;
  const char* what;
};
constexpr char kBeforeRename[] = "MUSCLEWARP_KILL_BEFORE_RENAME";
constexpr char kAfterRename[] = "MUSCLEWARP_KILL_AFTER_RENAME";
constexpr char kAfterRemove[] = "MUSCLEWARP_KILL_AFTER_REMOVE";

// In the order in which a run comes by them. Every kill but the first is of a
// run that resumes the one that was killed before it.
constexpr Kill kKills[] = {
    {kBeforeRename, "/.resume/inputs"},
    {kAfterRename, "/.resume/inputs"},
    {kBeforeRename, ".frame_0000/shank.ply"},  // among its meshes
    {kBeforeRename, "/frame_0000"},
    {kBeforeRename, "/.resume/frame_0000.cbor"},
    // No frame is done yet: what is there of the first is removed.
    {kAfterRename, "/.frame_0000.partial.replaced"},
    {kAfterRemove, "muscle.ply"},
    {kAfterRename, "/.resume/frame_0000.cbor"},
    // The rest pose is written anew over that of the run before.
    {kAfterRename, ".rest.replaced"},
    {kAfterRemove, "muscle.ply"},
    {kBeforeRename, "/frame_0006"},
    {kBeforeRename, "/.resume/frame_0006.cbor"},
    {kBeforeRename, "/report.json"},  // all frames are done
    {kBeforeRename, "/lengths.sto"},
    {kAfterRename, "/moment_arms.sto"},
    {kAfterRename, "/report.json"},
};

// Every file that the run in `dir` shows is as in `whole`, and no folder that
// it shows lacks one.
void ExpectComplete(const std::string& dir,
                    const std::map<std::string, std::string>& whole) {
  const auto is_hidden = [](const std::string& name) { return name[0] == '.'; };
  for (const auto& [name, bytes] : Contents(dir)) {
    if (is_hidden(name)) continue;
    ASSERT_EQ(whole.count(name), 1u) << name;
    EXPECT_TRUE(bytes == whole.at(name)) << name;
  }
  for (const auto& [name, bytes] : whole) {
    const fs::path path = fs::path(dir) / name;
    if (path.parent_path() == dir || !fs::exists(path.parent_path())) continue;
    EXPECT_TRUE(fs::exists(path)) << path;
  }
  if (!fs::exists(dir + "/report.json")) return;
  const Json report = Json::parse(FileText(dir + "/report.json"));
  for (const Json& frame : report["frames"]) {
    char folder[32];
    std::snprintf(
        folder, sizeof(folder), "/frame_%04d", frame["index"].get<int>());
    EXPECT_TRUE(fs::exists(dir + folder)) << folder;
  }
}

TEST_F(MotionProgram, AKilledRunGoesOnToTheSameBytes) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer must be the first library that is loaded";
#endif
  const std::string flags = "--frames=0:6:6 --fibres=2";
  ASSERT_EQ(Run(flags).exit_code, 0);
  const auto whole = Contents(out());
  const Json report = WithoutTimes(Report());
  const std::string broken = dir_ + "/broken";
  const std::string arguments = Arguments(flags + " --resume", broken);
  for (const Kill& kill : kKills) {
    SCOPED_TRACE(std::string(kill.when) + " " + kill.what);
    const ProgramRun run = RunCommandLine(
        std::string(kill.when) + "=" + kill.what +
            " LD_PRELOAD=" MUSCLEWARP_KILL_AT_FILE_CHANGE " " MUSCLEWARP_DEFORM,
        arguments);
    // The shell that ran it says so, or was replaced by it.
    ASSERT_THAT(run.exit_code, AnyOf(128 + SIGKILL, -1)) << run.errors;
    ExpectComplete(broken, whole);
  }
  const ProgramRun run = RunCommandLine(MUSCLEWARP_DEFORM, arguments);
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  ExpectComplete(broken, whole);
  EXPECT_EQ(Names(Contents(broken)), Names(whole));
  EXPECT_EQ(WithoutTimes(Json::parse(FileText(broken + "/report.json"))),
            report);
}

TEST_F(MotionProgram, AFinishedRunHasNothingToGoOnWith) {
  ASSERT_EQ(Run().exit_code, 0);
  const auto whole = Contents(out());
  ProgramRun run = Run("--resume");
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.out, HasSubstr("finished already"));
  // With other options it is another run, which does not go on with this one.
  run = Run("--resume --frames=0:2");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(
      run.errors,
      AllOf(HasSubstr("--resume"), HasSubstr("other input or options")));
  EXPECT_EQ(Contents(out()), whole);
}

// What a run by other sources has finished is not taken for this program's.
TEST_F(MotionProgram, AFinishedRunByOtherCodeIsRefused) {
  ASSERT_EQ(Run("--frames=0").exit_code, 0);
  Json report = Report();
  report["code"] = "0.1.0 of another day";
  WriteTextAtomically(out() + "/report.json", report.dump());
  const ProgramRun run = Run("--resume --frames=0");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(
      run.errors,
      AllOf(HasSubstr("other code"), HasSubstr("0.1.0 of another day")));
  EXPECT_EQ(Report(), report);
}

TEST_F(MotionProgram, FramesOfAnEarlierRunAreRemoved) {
  ASSERT_EQ(Run("--frames=0:2").exit_code, 0);
  const ProgramRun run = Run("--frames=0");
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.out, HasSubstr("removed 3 frames of an earlier run"));
  EXPECT_TRUE(fs::exists(out() + "/frame_0000"));
  EXPECT_FALSE(fs::exists(out() + "/frame_0001"));
  fs::create_directories(out() + "/frame_0007");
  EXPECT_EQ(Run("--frames=0").exit_code, 2);
  EXPECT_TRUE(fs::exists(out() + "/frame_0000/lines.json"));
  EXPECT_EQ(Run("--frames=0 --overwrite").exit_code, 0);
  EXPECT_FALSE(fs::exists(out() + "/frame_0007"));
}

TEST_F(MotionProgram, ResumeIsForTheSameInput) {
  fs::create_directories(out() + "/.resume");
  WriteTextAtomically(out() + "/.resume/inputs", "0123456789abcdef");
  const ProgramRun run = Run("--resume");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.errors, AllOf(HasSubstr("--resume"), HasSubstr("other")));
  EXPECT_FALSE(fs::exists(out() + "/report.json"));
  EXPECT_EQ(Run().exit_code, 0);  // starts anew
  EXPECT_FALSE(fs::exists(out() + "/.resume"));
}

}  // namespace
}  // namespace musclewarp
