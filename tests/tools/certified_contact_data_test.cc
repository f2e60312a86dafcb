// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdio>
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
// nothing that crosses in the files of one of them, the `checked` one.
void ExpectCertified(const Json& report, const std::string& out, int checked) {
  constexpr double kGap = 0.1;  // mm: the default of --gap
  EXPECT_EQ(report["rest"]["after_initial_fix"]["triangle_pairs"], 0);
  EXPECT_GT(report["rest"]["intersections"]["triangle_pairs"], 1000);
  EXPECT_EQ(report["summary"]["frames_clean"], report["summary"]["frames"]);
  for (const Json& frame : report["frames"]) {
    EXPECT_TRUE(frame["usable"]) << frame["name"] << frame["shortcomings"];
    EXPECT_EQ(frame["intersections"]["triangle_pairs"], 0) << frame["name"];
    EXPECT_EQ(frame["intersections"]["vertices_inside"], 0) << frame["name"];
    EXPECT_GE(frame["smallest_gap_mm"], kGap) << frame["name"];
    for (const Json& muscle : frame["muscles"]) {
      EXPECT_NEAR(muscle["volume_error"], 0, 4e-4) << muscle["name"];
      EXPECT_LE(muscle["torn_patch_mm2"], 100)
          << frame["name"] << muscle["name"];
      EXPECT_LE(muscle["max_contact_displacement_mm"],
                std::max(1.5,
                         muscle["depth_without_contact_mm"].get<double>() +
                             muscle["push_depth_mm"].get<double>() + 1))
          << frame["name"] << muscle["name"];
    }
  }
  char folder[32];
  std::snprintf(folder, sizeof(folder), "/frame_%04d/", checked);
  std::string files;
  for (const char* kind : {"muscles", "bones"}) {
    for (const Json& mesh : report["prepare"][kind]) {
      files += out + folder + mesh["name"].get<std::string>() + ".ply ";
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

// What the separation of the rest pose drew out is removed, up to what the
// relaxation afterwards adds to 1.5 (DrawnOutOptions).
void ExpectNothingDrawnOutAtRest(const Json& report) {
  int removed = 0;
  for (const Json& muscle : report["prepare"]["muscles"]) {
    removed += muscle["repairs"]["drawn_out_triangles_removed"].get<int>();
  }
  EXPECT_GT(removed, 0);
  const Json& rest = report["frames"][0];
  EXPECT_EQ(rest["name"], "rest");
  for (const Json& muscle : rest["muscles"]) {
    EXPECT_LE(muscle["shape"]["triangle_stretch"]["largest"], 1.7)
        << muscle["name"];
  }
}

std::string SceneFile(const std::string& name) {
  return MUSCLEWARP_DATA_DIR "/scenes/" + name + ".json";
}

TEST_F(ProgramsDataTest, CertifiedContactHoldsForTheBodyParts3dHip) {
  const std::string out = TestTempDir() + "/run";
  ExpectCertified(DeformFile(SceneFile("bodyparts3d_hip"), out), out, 2);
}

TEST_F(ProgramsDataTest, CertifiedContactHoldsForTheHamstrings) {
  const std::string out = TestTempDir() + "/run";
  const std::string scene = SceneFile("bodyparts3d_hamstrings_leg");
  ExpectCertified(DeformFile(scene, out, "--frames=0:2"), out, 2);
}

TEST_F(ProgramsDataTest, CertifiedContactHoldsForTheOriginalHamstrings) {
  const std::string out = TestTempDir() + "/run";
  const std::string scene = SceneFile("bodyparts3d_hamstrings_leg_original");
  ExpectCertified(DeformFile(scene, out, "--frames=0:2"), out, 2);
}

// Lines and attachments in use, up to 60 degrees.
TEST_F(ProgramsDataTest, CertifiedContactHoldsForLhdlFlexion) {
  const std::string out = TestTempDir() + "/run";
  ExpectCertified(DeformFile(SceneFile("lhdl_hip_attached"), out), out, 35);
}

// The repaired originals, with their slivers.
TEST_F(ProgramsDataTest, CertifiedContactHoldsForTheOriginalHip) {
  const std::string out = TestTempDir() + "/run";
  const std::string scene = SceneFile("bodyparts3d_hip_original");
  const Json report = DeformFile(scene, out, "--frames=0:3");
  ExpectCertified(report, out, 2);
  ExpectNothingDrawnOutAtRest(report);
}

// One pose each of the anatomies of many muscles, whose preparation takes most
// of the time; scripts/try_poses.py runs the others.
TEST_F(ProgramsDataTest, CertifiedContactHoldsForTheThigh) {
  const std::string out = TestTempDir() + "/run";
  const std::string scene = SceneFile("bodyparts3d_thigh");
  ExpectCertified(DeformFile(scene, out, "--frames=1"), out, 1);
}

TEST_F(ProgramsDataTest, CertifiedContactHoldsForTheShank) {
  const std::string out = TestTempDir() + "/run";
  const std::string scene = root_ + "/bodyparts3d_shank/scene_uniform.json";
  ExpectCertified(DeformFile(scene, out, "--frames=1"), out, 1);
}

TEST_F(ProgramsDataTest, CertifiedContactHoldsForTheShoulder) {
  const std::string out = TestTempDir() + "/run";
  const std::string scene = root_ + "/bodyparts3d_shoulder/scene_uniform.json";
  ExpectCertified(DeformFile(scene, out, "--frames=3"), out, 3);
}

}  // namespace
}  // namespace musclewarp
