// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "musclewarp/base/output_file.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "support/meshes.h"
#include "support/temp_dir.h"
#include "tools/run_program.h"

namespace musclewarp {
namespace {

using Json = nlohmann::json;
using ::testing::HasSubstr;

ProgramRun Compare(const std::string& arguments) {
  return RunCommandLine(
      MUSCLEWARP_COMPARE,
      "--scene=" MUSCLEWARP_DATA_DIR "/phantom/scene.json " + arguments);
}

int Lines(const std::string& text) {
  return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace

TEST(CompareProgram, ComparesAllConfigurations) {
  const std::string out = TestTempDir() + "/out";
  const ProgramRun run =
      Compare("--frames=last --coarse_vertices=60 --out=" + out);
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const Json comparison = Json::parse(FileText(out + "/comparison.json"));
  ASSERT_EQ(comparison["rows"].size(), 6u);
  size_t iterations = 0;
  for (const Json& row : comparison["rows"]) {
    EXPECT_THAT(run.out, HasSubstr(row["configuration"].get<std::string>()));
    EXPECT_EQ(row["stop_reason"], "converged") << row["configuration"];
    // All of them find the same minimum.
    EXPECT_NEAR(row["cost_ratio"], 1, 1e-6) << row["configuration"];
    EXPECT_NEAR(row["volume_ratio"], 1, 1e-6) << row["configuration"];
    EXPECT_LT(row["distance_to_reference_mm"], 1e-2) << row["configuration"];
    EXPECT_GT(row["iterations"], 0);
    for (const Json& muscle : row["muscles"]) {
      iterations += muscle["history"].size();
    }
  }
  EXPECT_EQ(Lines(FileText(out + "/comparison.csv")), 1 + 6);
  EXPECT_EQ(Lines(FileText(out + "/history.csv")),
            1 + static_cast<int>(iterations));
}

TEST(CompareProgram, ContactKeepsMusclesApart) {
  const std::string out = TestTempDir() + "/out";
  const ProgramRun run = Compare(
      "--frames=last --configurations=reference,ceres --contact=none,paper "
      "--out=" +
      out);
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const Json comparison = Json::parse(FileText(out + "/comparison.json"));
  std::map<std::string, Json> rows;
  for (const Json& row : comparison["rows"]) {
    rows[row["configuration"].get<std::string>() + " " +
         row["contact"].get<std::string>()] = row;
  }
  ASSERT_EQ(rows.size(), 4u);
  for (const char* solver : {"reference", "ceres"}) {
    const Json& none = rows[std::string(solver) + " none"];
    const Json& paper = rows[std::string(solver) + " paper/coarse"];
    EXPECT_GT(none["vertices_inside"], 100);
    EXPECT_LE(paper["vertices_inside"].get<int>(),
              none["vertices_inside"].get<int>() / 10);
    EXPECT_NEAR(paper["volume_ratio"], 1, 1e-6);
    EXPECT_EQ(paper["stop_reason"], "converged");
  }
}

TEST(CompareProgram, AllContactsSolveTheSceneThatCertifiedContactHasRemade) {
  // A bone in the end of a muscle, which moving vertices does not get out.
  const std::string dir = TestTempDir();
  WriteTriangleSoup(dir + "/muscle.ply", Spindle(12, 60, 3));
  WriteTriangleSoup(dir + "/bone.ply", MovedBy(Spindle(7, 50, 3), {0, 3, 66}));
  WriteTextAtomically(dir + "/scene.json",
                      R"({"name": "end in bone", "units": "mm",
      "muscles": [{"name": "muscle", "mesh": "muscle.ply", "lines":
        [{"name": "line", "rest": [[0,0,-55],[0,0,0],[0,0,55]]}]}],
      "bones": [{"name": "bone", "mesh": "bone.ply", "body": "bone"}],
      "poses": [{"name": "rest"}]})");
  const std::string flags = "--configurations=ceres --scene=" + dir +
                            "/scene.json --out=" + dir + "/out --contact=";
  const auto depth_without_contact = [&](const std::string& contacts) {
    const ProgramRun run = Compare(flags + contacts);
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_EQ(run.out.find("made anew") != std::string::npos,
              contacts != "none");
    const Json rows =
        Json::parse(FileText(dir + "/out/comparison.json"))["rows"];
    for (const Json& row : rows) {
      EXPECT_NEAR(row["volume_ratio"], 1, 1e-6);
      if (row["contact"] == "certified") {
        EXPECT_EQ(row["triangle_pairs"], 0);
      }
    }
    return rows[0]["max_depth_mm"].get<double>();
  };
  // The tip of the bone is between the samples of the new surface.
  EXPECT_GT(depth_without_contact("none"),
            5 * depth_without_contact("none,certified"));
}

TEST(CompareProgram, AConfigurationThatDoesNotGetThereIsARow) {
  TestTempDir();
  const ProgramRun run = Compare(
      "--frames=last --configurations=reference,ceres --max_iterations=2");
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.out, HasSubstr("iteration_limit"));
}

TEST(CompareProgram, RefusesBadFlags) {
  TestTempDir();
  const auto expect_refused = [](const std::string& flags,
                                 const std::string& word) {
    const ProgramRun run = Compare(flags);
    EXPECT_EQ(run.exit_code, 2) << flags;
    EXPECT_THAT(run.errors, HasSubstr(word)) << flags;
  };
  expect_refused("--configurations=newton", "ceres_cgnr");
  expect_refused("--configurations=", "--configurations");
  expect_refused("--contact=some", "certified, paper, none");
  expect_refused("--contact_level=medium", "coarse, fine");
  expect_refused("--repeat=0", "--repeat");
  expect_refused("--max_iterations=0", "--max_iterations");
  expect_refused("--bone_coarse_vertices=3 --contact=paper", "20 to 5000");
  expect_refused("--frames=99", "--frames");
}

}  // namespace musclewarp
