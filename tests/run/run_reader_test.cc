// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/run/run_outline.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "run/written_run.h"
#include "support/input_errors.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(RunOutline, IsWhatTheReportSays) {
  const WrittenRun written = WriteRun(TestTempDir());
  const RunOutline run = ReadRunOutline(written.dir, "0");
  EXPECT_THAT(run.warnings, IsEmpty());
  EXPECT_EQ(run.axes, "ASR");
  EXPECT_THAT(run.names.muscles, ElementsAre("muscle"));
  EXPECT_THAT(run.names.bones, ElementsAre("bone"));
  ASSERT_EQ(run.frames.size(), 2u);
  EXPECT_EQ(run.frames[1].folder, written.dir + "/frame_0001");
  EXPECT_EQ(run.frames[1].pose.name, written.report["frames"][1]["name"]);
}

TEST(RunOutline, WarnsOfWhatIsNotAsItShouldBe) {
  WrittenRun written = WriteRun(TestTempDir());
  written.report["summary"] = {{"finished", false}, {"usable", false}};
  written.WriteReport();
  std::filesystem::remove_all(written.dir + "/frame_0000");
  const RunOutline run = ReadRunOutline(written.dir, "1");
  EXPECT_THAT(run.warnings,
              ElementsAre(HasSubstr("of version 0, this program of 1"),
                          HasSubstr("not finished"),
                          HasSubstr("not usable"),
                          HasSubstr("frame_0000")));
  EXPECT_EQ(run.frames.size(), 1u);
}

TEST(RunOutline, WhatIsMissingIsNamed) {
  const std::string dir = TestTempDir();
  ExpectInputError([&] { ReadRunOutline(dir + "/none", "0"); },
                   {dir + "/none", "--in"});
  ExpectInputError([&] { ReadRunOutline(dir, "0"); }, {"report.json"});
  const WrittenRun good = WriteRun(dir);
  for (const char* key : {"scene",
                          "axes",
                          "contact",
                          "prepare",
                          "version",
                          "summary",
                          "frames"}) {
    WrittenRun bad = good;
    bad.report.erase(key);
    bad.WriteReport();
    ExpectInputError([&] { ReadRunOutline(dir, "0"); },
                     {"report.json", key, "is missing"});
  }
  WrittenRun bad = good;
  bad.report["axes"] = "LLL";
  bad.WriteReport();
  ExpectInputError([&] { ReadRunOutline(dir, "0"); },
                   {"report.json: axes", "LLL"});
  bad = good;
  bad.report["frames"] = nlohmann::ordered_json::array();
  bad.WriteReport();
  ExpectInputError([&] { ReadRunOutline(dir, "0"); }, {dir, "no frame"});
}

}  // namespace
}  // namespace musclewarp
