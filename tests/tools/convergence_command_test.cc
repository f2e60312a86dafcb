// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/convergence_command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "support/input_errors.h"
#include "support/temp_dir.h"
#include "tools/run_program.h"

namespace musclewarp {
namespace {

using Json = nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

ConvergenceOptions EmbeddedScene() {
  ConvergenceOptions options;
  options.deform.scene = MUSCLEWARP_DATA_DIR "/phantom/scene.json";
  options.deform.frames = "last";
  options.deform.deformer.frames.contact = ContactKind::kNone;
  options.deform.deformer.prepare.muscle.hull.coarse_vertices = 60;
  options.values.vertices = {100};
  options.values.spacings = {5};
  options.values.densities = {4};
  return options;
}

}  // namespace

TEST(ConvergenceCommand, ListsMayBeEmptyAndUnsorted) {
  StudyValues values =
      StudyValuesOf({true, "600,100", "2.5,40", "0.25,1,4,16"});
  EXPECT_THAT(values.vertices, ElementsAre(600, 100));
  EXPECT_THAT(values.spacings, ElementsAre(2.5, 40));
  EXPECT_THAT(values.densities, ElementsAre(0.25, 1, 4, 16));
  values = StudyValuesOf({true, "", "", ""});
  EXPECT_THAT(values.vertices, IsEmpty());
  EXPECT_THAT(values.spacings, IsEmpty());
  EXPECT_THAT(values.densities, IsEmpty());
}

TEST(ConvergenceCommand, RefusesBadLists) {
  for (const char* text : {"19", "5001", "many", "100,,200", "100.5", "1e3"}) {
    ExpectInputError(
        [&] {
          StudyValuesOf({true, text, "", ""});
        },
        {"--convergence_vertices", "20 to 5000"});
  }
  for (const char* text : {"0", "-1", "5 mm", "nan"}) {
    ExpectInputError(
        [&] {
          StudyValuesOf({true, "", text, ""});
        },
        {"--convergence_spacing", "0.01 mm or above"});
  }
  for (const char* text : {"2", "64", "0.5", "0", "-4", "1/4"}) {
    ExpectInputError(
        [&] {
          StudyValuesOf({true, "", "", text});
        },
        {"--convergence_density", "0.25, 1, 4 and 16"});
  }
  for (const char* text : {"paper", "none,certified", "some", ""}) {
    ExpectInputError([&] { ParseConvergenceContact(text); },
                     {"--contact", "none, certified"});
  }
  ConvergenceOptions options = EmbeddedScene();
  options.values = {{}, {}, {}};
  std::ostringstream screen;
  ExpectInputError([&] { ConvergenceCommand(options, screen); },
                   {"--convergence", "--convergence_spacing"});
}

TEST(ConvergenceCommand, WritesTheStudiesOfTheEmbeddedScene) {
  ConvergenceOptions options = EmbeddedScene();
  options.deform.out = TestTempDir() + "/out";
  std::ostringstream screen;
  ASSERT_EQ(ConvergenceCommand(options, screen), 0);
  const Json json =
      Json::parse(FileText(options.deform.out + "/convergence.json"));
  EXPECT_EQ(json["contact"], "none");
  EXPECT_EQ(json["as_set"]["coarse_vertices"], 60);
  // Three studies of two values, and three muscles.
  ASSERT_EQ(json["rows"].size(), 3u * 2 * 3);
  for (const Json& row : json["rows"]) {
    EXPECT_EQ(row["failure"], "");
    EXPECT_NEAR(row["volume_ratio"], 1, 1e-6);
    EXPECT_GE(row["stretch_999"], row["stretch_99"]);
    EXPECT_GE(row["stretch_largest"], row["stretch_999"]);
    if (row["finest"]) {
      EXPECT_EQ(row["largest_distance_mm"], 0);
      continue;
    }
    EXPECT_GT(row["largest_distance_mm"], row["mean_distance_mm"]);
    EXPECT_LT(row["largest_distance_mm"], 30);
  }
  const std::string csv = FileText(options.deform.out + "/convergence.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 3 * 2 * 3);
  EXPECT_THAT(screen.str(), HasSubstr("psoas_major_r: hulls of 60 vertices: "));
  EXPECT_THAT(screen.str(), HasSubstr("samples every 10 mm: "));
}

TEST(ConvergenceCommand, TheProgramRefusesFlagsThatDoNotGoTogether) {
  TestTempDir();
  const auto expect_refused = [](const std::string& flags,
                                 const std::string& word) {
    const ProgramRun run = RunCommandLine(
        MUSCLEWARP_COMPARE,
        "--scene=" MUSCLEWARP_DATA_DIR "/phantom/scene.json " + flags);
    EXPECT_EQ(run.exit_code, 2) << flags;
    EXPECT_THAT(run.errors, HasSubstr(word)) << flags;
  };
  expect_refused("--convergence --contact=paper", "none, certified");
  expect_refused("--convergence --configurations=ceres", "--configurations");
  expect_refused("--convergence --repeat=2", "--repeat");
  expect_refused("--convergence --convergence_density=2", "0.25, 1, 4 and 16");
  expect_refused("--convergence --coarse_vertices=3", "--coarse_vertices");
  expect_refused("--convergence_density=4", "needs --convergence");
}

}  // namespace musclewarp
