// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/run/run_reader.h"

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

TEST(RunReader, IsWhatTheReportSays) {
  const WrittenRun written = WriteRun(TestTempDir());
  const RunOutline run = ReadRunForExport(written.dir, "0");
  EXPECT_THAT(run.warnings, IsEmpty());
  EXPECT_EQ(run.axes, "ASR");
  EXPECT_THAT(run.names.muscles, ElementsAre("muscle"));
  EXPECT_THAT(run.names.bones, ElementsAre("bone"));
  ASSERT_EQ(run.frames.size(), 2u);
  EXPECT_EQ(run.frames[1].folder, written.dir + "/frame_0001");
  EXPECT_EQ(run.frames[1].figures.name, written.report["frames"][1]["name"]);
}

TEST(RunReader, WarnsOfWhatIsNotAsItShouldBe) {
  WrittenRun written = WriteRun(TestTempDir());
  written.report["summary"] = {{"finished", false}, {"usable", false}};
  written.WriteReport();
  std::filesystem::remove_all(written.dir + "/frame_0000");
  const RunOutline run = ReadRunForExport(written.dir, "1");
  EXPECT_THAT(run.warnings,
              ElementsAre(HasSubstr("of version 0, this program of 1"),
                          HasSubstr("not finished"),
                          HasSubstr("not usable"),
                          HasSubstr("frame_0000")));
  EXPECT_EQ(run.frames.size(), 1u);
}

// Whatever the reason was, what a report calls not usable stays so.
TEST(RunReader, BelievesThatAFrameIsNotUsable) {
  WrittenRun written = WriteRun(TestTempDir());
  EXPECT_TRUE(ReadRunForExport(written.dir, "0").frames[1].figures.IsUsable());
  written.report["frames"][1]["usable"] = false;
  written.WriteReport();
  EXPECT_FALSE(ReadRunForExport(written.dir, "0").frames[1].figures.IsUsable());
}

TEST(RunReader, RefusesFiguresThatMakeNoSense) {
  const WrittenRun good = WriteRun(TestTempDir());
  WrittenRun bad = good;
  bad.report["frames"][1]["muscles"][0]["self_pairs"] = -2;
  bad.WriteReport();
  ExpectInputError(
      [&] { ReadRunForExport(good.dir, "0"); },
      {"report.json: frames[1].muscles[0].self_pairs is -2, allowed: 0"});
  bad.report["frames"][1]["muscles"][0]["self_pairs"] = nullptr;
  bad.WriteReport();
  ExpectInputError([&] { ReadRunForExport(good.dir, "0"); },
                   {"frames[1].muscles[0].self_pairs: is null"});
}

TEST(RunReader, NamesMayHoldAnything) {
  const std::string name = "a \"quoted\"\nname";
  const WrittenRun written = WriteRun(TestTempDir(), name);
  const RunOutline run = ReadRunForExport(written.dir, "0");
  EXPECT_THAT(run.names.muscles, ElementsAre(name));
  EXPECT_EQ(run.frames[0].figures.muscles[0].name, name);
}

TEST(RunReader, WhatIsMissingIsNamed) {
  const std::string dir = TestTempDir();
  ExpectInputError([&] { ReadRunForExport(dir + "/none", "0"); },
                   {dir + "/none", "no such folder"});
  ExpectInputError([&] { ReadRunForExport(dir, "0"); }, {"report.json"});
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
    ExpectInputError([&] { ReadRunForExport(dir, "0"); },
                     {"report.json", key, "is missing"});
  }
  WrittenRun bad = good;
  bad.report["axes"] = "LLL";
  bad.WriteReport();
  ExpectInputError([&] { ReadRunForExport(dir, "0"); },
                   {"report.json: axes", "LLL"});
  bad = good;
  bad.report["frames"] = nlohmann::ordered_json::array();
  bad.WriteReport();
  ExpectInputError([&] { ReadRunForExport(dir, "0"); }, {dir, "no frame"});
}

}  // namespace
}  // namespace musclewarp
