// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "musclewarp/base/output_file.h"
#include "page/packed_text.h"
#include "support/temp_dir.h"
#include "tools/run_program.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

ProgramRun Report(const std::string& arguments) {
  return RunCommandLine(MUSCLEWARP_REPORT, arguments);
}

// Two frames of the embedded scene; `flags` for musclewarp-deform.
std::string EmbeddedRun(const std::string& dir, const std::string& flags = "") {
  const std::string out = dir + "/out";
  EXPECT_EQ(
      RunCommandLine(MUSCLEWARP_DEFORM,
                     std::string("--scene=") + MUSCLEWARP_DATA_DIR +
                         "/phantom/scene.json --frames=0:2 --contact=none "
                         "--out=" +
                         out + " " + flags)
          .exit_code,
      0);
  return out;
}

TEST(ReportProgram, WritesOnePageThatLoadsNothing) {
  const std::string dir = TestTempDir();
  const std::string run = EmbeddedRun(dir, "--html --fibres=3");
  const std::string page = dir + "/page.html";
  const ProgramRun report = Report("--in=" + run + " --out=" + page);
  EXPECT_EQ(report.exit_code, 0) << report.errors;
  EXPECT_THAT(report.out, HasSubstr("wrote " + page));
  const std::string html = FileText(page);
  EXPECT_EQ(html, FileText(run + "/report.html"));
  EXPECT_THAT(html,
              AllOf(HasSubstr("default-src 'none'"),
                    Not(HasSubstr(" src=\"http")),
                    Not(HasSubstr("<link rel=\"stylesheet\""))));
}

TEST(ReportProgram, ComparesTwoRuns) {
  const std::string dir = TestTempDir();
  const std::string run = EmbeddedRun(dir);
  fs::copy(run, dir + "/other", fs::copy_options::recursive);
  const ProgramRun report = Report("--in=" + run + " --compare=" + dir +
                                   "/other --out=" + dir + "/both.html");
  EXPECT_EQ(report.exit_code, 0) << report.errors;
  const Json runs = PageJson(FileText(dir + "/both.html"), "runs")["runs"];
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[0]["folder"], "out");
  EXPECT_EQ(runs[1]["folder"], "other");
}

TEST(ReportProgram, BadInputIsNamedAndLeavesNothing) {
  const std::string dir = TestTempDir();
  const std::string page = dir + "/page.html";
  const auto refused = [&](const std::string& arguments,
                           const std::string& words) {
    const ProgramRun report = Report(arguments);
    EXPECT_EQ(report.exit_code, 2) << arguments;
    EXPECT_THAT(report.errors, HasSubstr(words)) << arguments;
    EXPECT_FALSE(fs::exists(page));
  };
  const std::string run = EmbeddedRun(dir);
  const std::string good = "--in=" + run + " --out=" + page;
  refused("--out=" + page, "--in");
  refused("--in=" + dir + "/none --out=" + page, "none");
  refused("--in=" + dir + " --out=" + page, "report.json");
  refused("--in=" + run + " --out=" + dir + "/page.pdf", "page.pdf");
  refused(good + " --axes=XYZ", "--axes");
  refused(good + " --side=up", "--side");
  refused(good + " --bone_triangles=3", "--bone_triangles");
  refused(good + " --compare=" + dir + "/none", "none");
  refused("--in=" + run + " --out=" + dir + "/none/page.html", "none");
  const std::string text = FileText(run + "/report.json");
  WriteTextAtomically(run + "/report.json", text.substr(0, text.size() / 2));
  refused(good, "report.json");
  Json damaged = Json::parse(text);
  damaged["frames"][1]["muscles"][0].erase("volume_ratio");
  WriteTextAtomically(run + "/report.json", damaged.dump());
  refused(good, "frames[1]");
}

}  // namespace
}  // namespace musclewarp
