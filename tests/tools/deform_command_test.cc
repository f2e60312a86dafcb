// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/deform_command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>

#include "musclewarp/base/output_file.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/program/program.h"
#include "page/packed_text.h"
#include "support/input_errors.h"
#include "support/meshes.h"
#include "support/temp_dir.h"
#include "tools/run_program.h"

namespace musclewarp {
namespace {

using Json = nlohmann::json;
using ::testing::HasSubstr;

// Calls `act` once, when `words` have been written.
class ActOnWords : public std::stringbuf {
 public:
  ActOnWords(std::string words, std::function<void()> act)
      : words_(std::move(words)), act_(std::move(act)) {}

 protected:
  std::streamsize xsputn(const char* text, std::streamsize size) override {
    const std::streamsize written = std::stringbuf::xsputn(text, size);
    if (act_ && str().find(words_) != std::string::npos) {
      std::exchange(act_, nullptr)();
    }
    return written;
  }

 private:
  std::string words_;
  std::function<void()> act_;
};

// A spindle that is bent in four frames of a motion.
DeformOptions SmallRun() {
  const std::string dir = TestTempDir();
  WriteTriangleSoup(dir + "/muscle.ply", Spindle(12, 60, 3));
  Json scene = Json::parse(R"({"name": "spindle", "units": "mm",
      "muscles": [{"name": "muscle", "mesh": "muscle.ply", "lines":
        [{"name": "line", "rest": [[0,0,-55],[0,0,0],[0,0,55]]}]}]})");
  for (int i = 0; i < 4; ++i) {
    scene["poses"].push_back(
        {{"name", std::to_string(i)},
         {"time", i},
         {"lines", {{"line", {{0, 0, -55}, {0, 0, 0}, {5 * i, 0, 54}}}}}});
  }
  WriteTextAtomically(dir + "/scene.json", scene.dump());
  DeformOptions options;
  options.scene = dir + "/scene.json";
  options.out = dir + "/out";
  options.command = "musclewarp-deform";
  options.html = true;
  return options;
}

// What the summary of the report is if `act` happens after the second frame.
Json SummaryAfter(const DeformOptions& options,
                  const std::function<void()>& act) {
  ActOnWords buffer("2 of 4", act);
  std::ostream screen(&buffer);
  EXPECT_EQ(DeformCommand(options, screen), kExitNotUsable);
  EXPECT_THAT(buffer.str(), HasSubstr("stopped after 2 of 4 frames"));
  EXPECT_THAT(buffer.str(), HasSubstr("--resume"));
  EXPECT_THAT(buffer.str(), HasSubstr("2 of 4 frames, "));
  EXPECT_THAT(buffer.str(), HasSubstr(": usable so far\n"));
  const Json report = Json::parse(FileText(options.out + "/report.json"));
  EXPECT_EQ(report["frames"].size(), 2u);
  EXPECT_EQ(report["summary"]["frames_planned"], 4);
  EXPECT_EQ(report["summary"]["finished"], false);
  return report["summary"];
}

TEST(DeformCommand, AnInterruptedRunSaysSoAndGoesOn) {
  DeformOptions options = SmallRun();
  const Json summary = SummaryAfter(options, [] { std::raise(SIGTERM); });
  EXPECT_THAT(summary["stopped"], HasSubstr("SIGTERM"));
  const std::string page = FileText(options.out + "/report.html");
  EXPECT_THAT(PageJson(page, "runs").dump(),
              HasSubstr("interrupted by SIGTERM"));
  options.resume = true;
  std::ostringstream screen;
  EXPECT_EQ(DeformCommand(options, screen), kExitUsable);
  EXPECT_THAT(screen.str(), HasSubstr("preparation read in"));
  const Json report = Json::parse(FileText(options.out + "/report.json"));
  EXPECT_EQ(report["frames"].size(), 4u);
  EXPECT_EQ(report["summary"]["finished"], true);
  EXPECT_TRUE(report["summary"]["stopped"].is_null());
}

// A run whose folder is emptied under it says what is missing, and is computed
// again by --resume.
TEST(DeformCommand, ARemovedFolderIsNoticed) {
  DeformOptions options = SmallRun();
  const auto remove = [&] { std::filesystem::remove_all(options.out); };
  ActOnWords buffer("2 of 4", remove);
  std::ostream screen(&buffer);
  EXPECT_EQ(DeformCommand(options, screen), kExitNotUsable);
  EXPECT_THAT(buffer.str(), HasSubstr("rest, frame_0000, frame_0001"));
  EXPECT_THAT(buffer.str(), HasSubstr("were removed during the run"));
  options.resume = true;
  std::ostringstream again;
  EXPECT_EQ(DeformCommand(options, again), kExitUsable);
  for (const char* name : {"rest", "frame_0000", "frame_0003"}) {
    EXPECT_TRUE(std::filesystem::exists(options.out + "/" + name)) << name;
  }
  const Json report = Json::parse(FileText(options.out + "/report.json"));
  EXPECT_EQ(report["frames"].size(), 4u);
}

TEST(DeformCommand, TwoRunsDoNotWriteIntoOneFolder) {
  const DeformOptions options = SmallRun();
  ActOnWords buffer("2 of 4", [&] {
    std::ostringstream screen;
    ExpectInputError([&] { DeformCommand(options, screen); },
                     {"--out=" + options.out, "another run", "wait until"});
  });
  std::ostream screen(&buffer);
  EXPECT_EQ(DeformCommand(options, screen), kExitUsable);
  const Json report = Json::parse(FileText(options.out + "/report.json"));
  EXPECT_EQ(report["frames"].size(), 4u);
  EXPECT_FALSE(std::filesystem::exists(options.out + "/.musclewarp.lock"));
}

TEST(DeformCommand, SignalsAreAsBeforeAfterwards) {
  DeformOptions options = SmallRun();
  std::ostringstream screen;
  DeformCommand(options, screen);
  struct sigaction now;
  sigaction(SIGTERM, nullptr, &now);
  EXPECT_EQ(now.sa_handler, SIG_DFL);
}

TEST(DeformCommand, AFrameThatCannotBeWrittenIsToldInTheReport) {
  DeformOptions options = SmallRun();
  options.html = false;
  rlimit before;
  getrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, SIG_IGN);  // files that grow too large are an error then
  // More than the report of two frames, less than a mesh.
  const Json summary = SummaryAfter(options, [&] {
    rlimit small = before;
    small.rlim_cur = 12000;
    setrlimit(RLIMIT_FSIZE, &small);
  });
  setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_THAT(summary["stopped"], HasSubstr("cannot be written"));
}

}  // namespace
}  // namespace musclewarp
