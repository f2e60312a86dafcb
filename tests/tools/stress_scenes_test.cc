// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "musclewarp/mesh_files/mesh_io.h"
#include "support/temp_dir.h"
#include "tools/run_program.h"

namespace musclewarp {
namespace {

using Json = nlohmann::json;

class StressScene : public ::testing::TestWithParam<const char*> {};

// Made by musclewarp-phantom, deformed by musclewarp-deform, and counted again
// by musclewarp-check.
TEST_P(StressScene, IsCertifiedInEveryPose) {
  const std::string dir = TestTempDir();
  ASSERT_EQ(RunCommandLine(MUSCLEWARP_PHANTOM,
                           std::string("--scene=") + GetParam() +
                               " --out=" + dir + "/scene")
                .exit_code,
            0);
  const ProgramRun run =
      RunCommandLine(MUSCLEWARP_DEFORM,
                     "--contact=certified --scene=" + dir +
                         "/scene/scene.json --out=" + dir + "/out");
  EXPECT_EQ(run.exit_code, 0) << run.out << run.errors;
  const Json report = Json::parse(FileText(dir + "/out/report.json"));
  // There is something to be done: at rest, or where it would go.
  EXPECT_GT(report["rest"]["intersections"]["triangle_pairs"], 50);
  for (const Json& frame : report["frames"]) {
    EXPECT_TRUE(frame["usable"]) << frame["name"] << frame["shortcomings"];
    EXPECT_EQ(frame["intersections"]["triangle_pairs"], 0) << frame["name"];
    EXPECT_EQ(frame["intersections"]["vertices_inside"], 0) << frame["name"];
    for (const Json& muscle : frame["muscles"]) {
      EXPECT_NEAR(muscle["volume_error"], 0, 1e-6) << muscle["name"];
    }
  }
  std::string files;
  for (const Json& mesh : report["prepare"]["muscles"]) {
    files +=
        dir + "/out/frame_0002/" + mesh["name"].get<std::string>() + ".ply ";
  }
  const std::string bone = report["prepare"]["bones"][0]["name"];
  files += dir + "/out/frame_0002/" + bone + ".ply";
  RunCommandLine(MUSCLEWARP_CHECK, "--json=" + dir + "/check.json " + files);
  const Json check = Json::parse(FileText(dir + "/check.json"));
  EXPECT_EQ(check["pairs"].size(),
            report["prepare"]["muscles"].size() *
                (report["prepare"]["muscles"].size() + 1) / 2);
  for (const Json& pair : check["pairs"]) {
    EXPECT_EQ(pair["triangle_pairs"], 0) << pair;
    EXPECT_EQ(pair["a_vertices_inside_b"], 0) << pair;
    EXPECT_EQ(pair["b_vertices_inside_a"], 0) << pair;
  }
}

INSTANTIATE_TEST_SUITE_P(Phantom,
                         StressScene,
                         ::testing::Values("stress_attachment",
                                           "stress_edge",
                                           "stress_plate",
                                           "stress_resolution",
                                           "stress_sheet",
                                           "stress_sweep"),
                         [](const auto& scene) {
                           return std::string(scene.param).substr(7);
                         });

}  // namespace
}  // namespace musclewarp
