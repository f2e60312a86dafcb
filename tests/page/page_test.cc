// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/page/page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "musclewarp/base/angles.h"
#include "page/packed_text.h"
#include "page/read_quietly.h"
#include "run/written_run.h"
#include "support/input_errors.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

using Json = nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(Page, HoldsTheRun) {
  const WrittenRun written = WriteRun(TestTempDir());
  const std::string html = PageHtml({ReadQuietly(written.dir)}, {});
  EXPECT_THAT(html, HasSubstr("<!doctype html>"));
  EXPECT_THAT(html, Not(HasSubstr("musclewarp:data")));
  const Json data = PageJson(html, "runs");
  const Json& run = data["runs"][0];
  EXPECT_EQ(run["muscles"][0]["name"], "muscle");
  EXPECT_EQ(run["muscles"][0]["vertices"], written.muscle.points.rows());
  EXPECT_EQ(run["bones"][0]["poses"].size(), 3u);
  EXPECT_EQ(run["frames"].size(), 2u);
  EXPECT_EQ(run["crossings"][2][0]["triangle_pairs"], written.pairs);
  EXPECT_FALSE(ScriptText(html, "numbers").empty());
}

TEST(Page, NamesCannotEndTheScript) {
  const std::string name = "<img src=x onerror=alert(1)><!--<script>";
  const std::string html =
      PageHtml({ReadQuietly(WriteRun(TestTempDir(), name).dir)}, {});
  EXPECT_THAT(html, Not(HasSubstr("<img src=x")));
  EXPECT_EQ(PageJson(html, "runs")["runs"][0]["muscles"][0]["name"], name);
}

TEST(Page, ViewsFollowTheAxesOfTheScene) {
  const WrittenRun written = WriteRun(TestTempDir());
  const auto lateral = [&](const PageOptions& options) {
    const Json data =
        PageJson(PageHtml({ReadQuietly(written.dir)}, options), "runs");
    return data["views"]["lateral"]["toward_viewer"];
  };
  // The scene has z to the right and is of a left leg.
  EXPECT_EQ(lateral({}), Json({0.0, 0.0, -1.0}));
  PageOptions options;
  options.axes = "LPS";
  EXPECT_EQ(lateral(options), Json({1.0, 0.0, 0.0}));
  options.side = "right";
  EXPECT_EQ(lateral(options), Json({-1.0, 0.0, 0.0}));
  options.axes = "LPP";
  ExpectInputError([&] { lateral(options); }, {"axes", "LPP"});
}

TEST(Page, HasMomentArmsOfCarriedLines) {
  WrittenRun written = WriteRun(TestTempDir());
  const auto expect_arms = [&](double expected) {
    const Json data =
        PageJson(PageHtml({ReadQuietly(written.dir)}, {}), "runs");
    const Json& arms = data["runs"][0]["carried_moment_arms_mm"];
    EXPECT_EQ(arms["coordinate"], "hip");
    ASSERT_EQ(arms["muscles"]["muscle"]["l"].size(), 2u);
    for (const double arm : arms["muscles"]["muscle"]["l"]) {
      EXPECT_NEAR(arm, expected, 1e-12);
    }
  };
  expect_arms(20.0 / 3);  // of SomeFigures
  // The paper's contact has none, but lengths of 100 and 101 mm, 10 degrees
  // apart.
  for (auto& frame : written.report["frames"]) {
    frame["muscles"][0]["line_moment_arms_mm"] = Json::object();
  }
  written.WriteReport();
  expect_arms(-1 / RadiansOf(10));
}

TEST(Page, RunsAreNamedApart) {
  const std::string dir = TestTempDir();
  const auto labels = [&](const std::string& a, const std::string& b) {
    const Json data =
        PageJson(PageHtml({ReadQuietly(a), ReadQuietly(b)}, {}), "runs");
    return std::vector<std::string>{data["runs"][0]["folder"],
                                    data["runs"][1]["folder"]};
  };
  for (const std::string name : {"/a/run", "/a/other", "/b/run"}) {
    WriteRun(dir + name);
  }
  EXPECT_EQ(labels(dir + "/a/run/", dir + "/a/other"),
            (std::vector<std::string>{"run", "other"}));
  EXPECT_EQ(labels(dir + "/a/run", dir + "/b/run"),
            (std::vector<std::string>{"a/run", "b/run"}));
}

TEST(Page, IsTheSameForTheSameRun) {
  const WrittenRun written = WriteRun(TestTempDir());
  EXPECT_EQ(PageHtml({ReadQuietly(written.dir)}, {}),
            PageHtml({ReadQuietly(written.dir)}, {}));
}

}  // namespace
}  // namespace musclewarp
