// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/run/earlier_run.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "musclewarp/base/output_file.h"
#include "musclewarp/run/resume_log.h"
#include "support/input_errors.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

// Writes the folder of a run with frames 0 and 7.
std::string RunFolder() {
  const std::string dir = TestTempDir();
  for (const char* name : {"frame_0000", "frame_0007", "rest", "pictures"}) {
    fs::create_directories(fs::path(dir) / name);
    WriteTextAtomically(dir + "/" + name + "/a.ply", "");
  }
  for (const char* name : {"lengths.sto", "report.html", "notes.txt"}) {
    WriteTextAtomically(dir + "/" + name, "");
  }
  WriteTextAtomically(dir + "/report.json",
                      R"({"inputs_hash": "a1", "code": "0.1.0 b2",
          "summary": {"finished": true, "usable": false},
          "frames": [{"index": 0}, {"index": 7}]})");
  return dir;
}

TEST(EarlierRun, IsWhatItsReportSays) {
  const auto run = ReadEarlierRun(RunFolder());
  ASSERT_TRUE(run);
  EXPECT_EQ(run->inputs_hash, "a1");
  EXPECT_EQ(run->code_key, "0.1.0 b2");
  EXPECT_TRUE(run->is_finished);
  EXPECT_FALSE(run->is_usable);
  EXPECT_EQ(run->frames,
            std::vector<std::string>({"frame_0000", "frame_0007"}));
  EXPECT_FALSE(ReadEarlierRun(TestTempDir() + "/nothing"));
}

TEST(EarlierRun, IsRemovedAndNothingElse) {
  const std::string dir = RunFolder();
  EXPECT_NO_THROW(CheckNoStrangeFrames(dir, false));
  EXPECT_EQ(RemoveEarlierRun(dir), 2);
  for (const char* name : {"frame_0000",
                           "frame_0007",
                           "rest",
                           "lengths.sto",
                           "report.html",
                           "report.json"}) {
    EXPECT_FALSE(fs::exists(dir + "/" + name)) << name;
  }
  EXPECT_TRUE(fs::exists(dir + "/notes.txt"));
  EXPECT_TRUE(fs::exists(dir + "/pictures/a.ply"));
}

// Where no run was, a table or page of that name is somebody else's.
TEST(EarlierRun, TablesAndPagesWithoutAReportStay) {
  const std::string dir = RunFolder();
  fs::remove(dir + "/report.json");
  RemoveEarlierRun(dir);
  EXPECT_TRUE(fs::exists(dir + "/lengths.sto"));
  EXPECT_TRUE(fs::exists(dir + "/report.html"));
}

TEST(EarlierRun, FramesThatNoReportNamesAreRefused) {
  const std::string dir = RunFolder();
  fs::create_directories(dir + "/frame_0003");
  ExpectInputError([&] { CheckNoStrangeFrames(dir, false); },
                   {dir, "frame_0003", "overwrite"});
  EXPECT_NO_THROW(CheckNoStrangeFrames(dir, true));
  // Those of a run that was interrupted are known.
  ResumeLog(dir, "hash").StartAnew();
  EXPECT_NO_THROW(CheckNoStrangeFrames(dir, false));
}

}  // namespace
}  // namespace musclewarp
