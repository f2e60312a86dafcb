// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/temp_dir.h"
#include "tools/programs_data.h"
#include "tools/run_program.h"

namespace musclewarp {
namespace {

using Json = nlohmann::json;

// Every frame holds what certified contact promises, and musclewarp-check finds
// nothing that crosses in the files of one of them.
void ExpectCertified(const Json& report, const std::string& out) {
  EXPECT_EQ(report["rest"]["after_initial_fix"]["triangle_pairs"], 0);
  EXPECT_GT(report["rest"]["intersections"]["triangle_pairs"], 1000);
  EXPECT_EQ(report["summary"]["frames_clean"], report["summary"]["frames"]);
  for (const Json& frame : report["frames"]) {
    EXPECT_TRUE(frame["usable"]) << frame["name"] << frame["shortcomings"];
    EXPECT_EQ(frame["intersections"]["triangle_pairs"], 0) << frame["name"];
    EXPECT_EQ(frame["intersections"]["vertices_inside"], 0) << frame["name"];
    for (const Json& muscle : frame["muscles"]) {
      EXPECT_NEAR(muscle["volume_error"], 0, 4e-4) << muscle["name"];
      EXPECT_LE(muscle["max_contact_displacement_mm"],
                muscle["depth_without_contact_mm"].get<double>() +
                    muscle["push_depth_mm"].get<double>() + 1)
          << frame["name"] << muscle["name"];
    }
  }
  std::string files;
  for (const char* kind : {"muscles", "bones"}) {
    for (const Json& mesh : report["prepare"][kind]) {
      files += out + "/frame_0002/" + mesh["name"].get<std::string>() + ".ply ";
    }
  }
  const std::string check_file = out + "/check.json";
  RunCommandLine(MUSCLEWARP_CHECK, "--json=" + check_file + " " + files);
  const Json check = Json::parse(FileText(check_file));
  const size_t muscles = report["prepare"]["muscles"].size();
  std::vector<std::string> bones;
  for (const Json& bone : report["prepare"]["bones"]) {
    bones.push_back(bone["name"]);
  }
  EXPECT_EQ(check["files"].size(), muscles + bones.size());
  int of_muscles = 0;
  for (const Json& pair : check["pairs"]) {
    const auto is_bone = [&](const char* key) {
      const std::string file = pair[key];
      return std::any_of(
          bones.begin(), bones.end(), [&](const std::string& name) {
            return file.find(name + ".ply") != std::string::npos;
          });
    };
    if (is_bone("a") && is_bone("b")) continue;
    ++of_muscles;
    EXPECT_EQ(pair["triangle_pairs"], 0) << pair;
  }
  EXPECT_GT(of_muscles, 0);
}

TEST_F(ProgramsDataTest, CertifiedContactHoldsForTheBodyParts3dHip) {
  const std::string out = TestTempDir() + "/run";
  ExpectCertified(
      Deform("bodyparts3d_hip", "ceres", out, "--contact=certified"), out);
}

TEST_F(ProgramsDataTest, CertifiedContactHoldsForTheHamstrings) {
  const std::string out = TestTempDir() + "/run";
  ExpectCertified(Deform("bodyparts3d_hamstrings_leg",
                         "ceres",
                         out,
                         "--contact=certified --frames=0:2"),
                  out);
}

TEST_F(ProgramsDataTest, CertifiedContactHoldsForTheOriginalHamstrings) {
  const std::string out = TestTempDir() + "/run";
  ExpectCertified(Deform("bodyparts3d_hamstrings_leg_original",
                         "ceres",
                         out,
                         "--contact=certified --frames=0:2"),
                  out);
}

// Lines and attachments in use.
TEST_F(ProgramsDataTest, CertifiedContactHoldsForLhdlFlexion) {
  const std::string out = TestTempDir() + "/run";
  ExpectCertified(Deform("lhdl_hip_attached",
                         "ceres",
                         out,
                         "--contact=certified --attachment_weight=1"),
                  out);
}

// The repaired originals, with their slivers.
TEST_F(ProgramsDataTest, CertifiedContactHoldsForTheOriginalHip) {
  const std::string out = TestTempDir() + "/run";
  ExpectCertified(Deform("bodyparts3d_hip_original",
                         "ceres",
                         out,
                         "--contact=certified --frames=0:3"),
                  out);
}

}  // namespace
}  // namespace musclewarp
