// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/deform_program.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "musclewarp/base/output_file.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "support/meshes.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;

std::string EmbeddedScene() {
  return std::string(MUSCLEWARP_DATA_DIR) + "/phantom/scene.json";
}

TEST_F(DeformProgram, WritesFramesAndReport) {
  const ProgramRun run = Run("--format=ply,obj");
  ASSERT_EQ(run.exit_code, 0) << run.out << run.errors;
  EXPECT_THAT(run.out, AllOf(HasSubstr("bent"), HasSubstr("usable")));
  for (const char* name : {"muscle.ply", "muscle.obj", "bone.ply"}) {
    EXPECT_TRUE(fs::exists(out() + "/frame_0001/" + name)) << name;
  }
  const Json report = Json::parse(FileText(out() + "/report.json"));
  EXPECT_EQ(report["scene"], "spindle");
  EXPECT_EQ(report["solver"], "ceres");
  EXPECT_EQ(report["contact"], "none");
  EXPECT_TRUE(report["prepare"]["muscles"][0]["hull_encloses"]);
  ASSERT_EQ(report["frames"].size(), 2u);
  EXPECT_EQ(report["frames"][1]["stop_reason"], "converged");
  EXPECT_NEAR(report["frames"][1]["muscles"][0]["volume_ratio"], 1, 1e-6);
  const Json& muscle = report["frames"][1]["muscles"][0];
  const double straight = 55 + std::hypot(30, 45);
  EXPECT_NEAR(muscle["path_lengths_mm"]["line"], straight, 1e-9);
  // The muscle follows, up to the weight of its shape.
  EXPECT_NEAR(muscle["line_lengths_mm"]["line"], straight, 1);
  EXPECT_TRUE(report["summary"]["usable"]);
  EXPECT_EQ(report["summary"]["frames"], 2);
}

TEST_F(DeformProgram, RestInRestOutOnDisk) {
  ASSERT_EQ(Run().exit_code, 0);
  const TriangleSoup muscle =
      ReadTriangleSoup(out() + "/frame_0000/muscle.ply");
  const TriangleSoup rest = ReadTriangleSoup(dir_ + "/muscle.ply");
  EXPECT_EQ(muscle.triangles, rest.triangles);
  EXPECT_LT((muscle.points - rest.points).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_EQ(ReadTriangleSoup(out() + "/frame_0000/bone.ply").points,
            ReadTriangleSoup(dir_ + "/bone.ply").points);
}

TEST_F(DeformProgram, ReportsIntersectionsAsCheckDoes) {
  ASSERT_EQ(Run().exit_code, 0);
  const std::string frame = out() + "/frame_0001/";
  ASSERT_EQ(RunCommandLine(MUSCLEWARP_CHECK,
                           frame + "muscle.ply " + frame +
                               "bone.ply --json=" + dir_ + "/check.json")
                .exit_code,
            0);
  const Json check = Json::parse(FileText(dir_ + "/check.json"));
  const Json report = Json::parse(FileText(out() + "/report.json"));
  const Json& counts = report["frames"][1]["intersections"];
  // The muscle bends into the bone.
  EXPECT_GT(counts["triangle_pairs"], 0);
  EXPECT_EQ(counts["triangle_pairs"], check["pairs"][0]["triangle_pairs"]);
  EXPECT_EQ(counts["max_depth_mm"], check["pairs"][0]["max_depth_mm"]);
  EXPECT_EQ(counts["vertices_inside"].get<int>(),
            check["pairs"][0]["a_vertices_inside_b"].get<int>() +
                check["pairs"][0]["b_vertices_inside_a"].get<int>());
  EXPECT_EQ(counts["self_pairs"], check["files"][0]["self_pairs"]);
}

TEST_F(DeformProgram, ReportsGapsThatCheckMeasures) {
  ASSERT_EQ(Run("--contact=certified").exit_code, 0);
  const std::string frame = out() + "/frame_0001/";
  ASSERT_EQ(RunCommandLine(MUSCLEWARP_CHECK,
                           frame + "muscle.ply " + frame +
                               "bone.ply --json=" + dir_ + "/check.json")
                .exit_code,
            0);
  const Json check = Json::parse(FileText(dir_ + "/check.json"));
  const Json report = Json::parse(FileText(out() + "/report.json"));
  const Json& gaps = report["frames"][1]["gaps"];
  ASSERT_EQ(gaps.size(), 1u);
  EXPECT_EQ(gaps[0]["a"], "muscle");
  EXPECT_EQ(gaps[0]["b"], "bone");
  const double distance = check["pairs"][0]["distance_mm"];
  EXPECT_GT(distance, 0);
  // Check does not prove its figure: it is off by some roundings.
  constexpr double kRounding = 1e-12;
  EXPECT_NEAR(gaps[0]["at_least_mm"], distance, kRounding);
  EXPECT_LE(gaps[0]["at_least_mm"], gaps[0]["at_most_mm"]);
  EXPECT_EQ(gaps[0]["place_mm"].size(), 3u);
  EXPECT_EQ(report["frames"][1]["smallest_gap_mm"], gaps[0]["at_least_mm"]);
}

TEST_F(DeformProgram, SelectsFrames) {
  ASSERT_EQ(Run("--frames=last").exit_code, 0);
  EXPECT_FALSE(fs::exists(out() + "/frame_0000"));
  EXPECT_TRUE(fs::exists(out() + "/frame_0001"));
}

// The second run reads what the first one prepared; other frames of the same
// scene may as well, another gap may not.
TEST_F(DeformProgram, ReadsThePreparationFromTheCache) {
  const std::string flags = "--contact=certified --cache=" + dir_ + "/cache";
  const auto run = [&](const std::string& more, bool is_cached) {
    ASSERT_LE(Run(flags + more).exit_code, 1);
    const Json report = Json::parse(FileText(out() + "/report.json"));
    EXPECT_EQ(report["prepare"]["cached"], is_cached) << more;
  };
  const std::string mesh = out() + "/frame_0001/muscle.ply";
  run("", false);
  const std::string before = FileText(mesh);
  run("", true);
  EXPECT_EQ(FileText(mesh), before);
  run(" --frames=1 --format=obj,ply --profile", true);
  EXPECT_EQ(FileText(mesh), before);
  EXPECT_FALSE(
      Json::parse(FileText(out() + "/report.json"))["frames"][0]["stages"]
          .empty());
  run(" --gap=0.2", false);
}

TEST_F(DeformProgram, BothSolversWriteTheSameShape) {
  ASSERT_EQ(Run("--solver=reference").exit_code, 0);
  const Points reference =
      ReadTriangleSoup(out() + "/frame_0001/muscle.ply").points;
  ASSERT_EQ(Run("--solver=ceres").exit_code, 0);
  const Points ceres =
      ReadTriangleSoup(out() + "/frame_0001/muscle.ply").points;
  EXPECT_LT((reference - ceres).rowwise().norm().maxCoeff(), 1e-3);
}

TEST_F(DeformProgram, FlagsInAFileServeToo) {
  WriteTextAtomically(dir_ + "/flags.txt", "--frames=0\n--solver=reference\n");
  ASSERT_EQ(Run("--flagfile=" + dir_ + "/flags.txt").exit_code, 0);
  EXPECT_EQ(Json::parse(FileText(out() + "/report.json"))["solver"],
            "reference");
}

TEST_F(DeformProgram, WarnsOfMeshesInOtherUnits) {
  TriangleSoup metres = Icosphere(10, 2);
  metres.points /= 1000;
  WriteTriangleSoup(dir_ + "/bone.ply", metres);
  const ProgramRun run = Run();
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.errors, AllOf(HasSubstr("bone"), HasSubstr("millimetres")));
  // The other one: the line does not go with so small a bone.
  const Json warnings =
      Json::parse(FileText(out() + "/report.json"))["prepare"]["warnings"];
  EXPECT_EQ(std::count_if(warnings.begin(),
                          warnings.end(),
                          [](const std::string& warning) {
                            return warning.find("millimetres") !=
                                   std::string::npos;
                          }),
            1);
}

TEST_F(DeformProgram, RefusesBadMeshes) {
  fs::remove(dir_ + "/muscle.ply");
  ExpectRefused({"muscle.ply"});
  WriteTextAtomically(dir_ + "/muscle.ply", "");
  ExpectRefused({"muscle.ply", "empty"});
  WriteTextAtomically(dir_ + "/muscle.ply", "a text\n");
  ExpectRefused({"muscle.ply"});
  WriteMuscle(Spindle(12, 60, 3));
  const std::string whole = FileText(dir_ + "/muscle.ply");
  WriteTextAtomically(dir_ + "/muscle.ply", whole.substr(0, whole.size() / 2));
  ExpectRefused({"muscle.ply", "truncated"});

  // The writer of the library refuses such meshes: they come as text.
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\n"
      "property double y\nproperty double z\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n";
  WriteTextAtomically(dir_ + "/muscle.ply", header + "0 nan 0\n3 0 1 2\n");
  ExpectRefused({"muscle.ply", "vertex 2", "finite"});
  WriteTextAtomically(dir_ + "/muscle.ply", header + "0 inf 0\n3 0 1 2\n");
  ExpectRefused({"muscle.ply", "vertex 2", "finite"});
  WriteTextAtomically(dir_ + "/muscle.ply", header + "0 1 0\n3 0 1 999\n");
  ExpectRefused({"muscle.ply", "face 0", "999"});
  std::string no_faces = header + "0 1 0\n";
  no_faces.replace(no_faces.find("face 1"), 6, "face 0");
  WriteTextAtomically(dir_ + "/muscle.ply", no_faces);
  ExpectRefused({"muscle.ply", "no faces"});
}

TEST_F(DeformProgram, RefusesALargeHoleAndSaysWhere) {
  TriangleSoup soup = Spindle(12, 60, 3);
  std::vector<Eigen::RowVector3i> kept;
  for (Eigen::Index f = 0; f < soup.triangles.rows(); ++f) {
    if (soup.points(soup.triangles(f, 0), 2) < 20) {
      kept.push_back(soup.triangles.row(f));
    }
  }
  soup.triangles.resize(kept.size(), 3);
  for (size_t f = 0; f < kept.size(); ++f) soup.triangles.row(f) = kept[f];
  WriteMuscle(soup);
  ExpectRefused({"muscle.ply", "mm", "around"});
}

TEST_F(DeformProgram, RefusesBadScenes) {
  scene_["muscels"] = 1;
  ExpectRefused({"scene.json", "muscels"});
  scene_.erase("muscels");
  scene_["poses"][1]["lines"]["line"].erase(0);
  ExpectRefused({"scene.json", "line", "bent"});
}

TEST_F(DeformProgram, RefusesBadFlags) {
  ExpectRefused({"--solver=newton", "ceres", "reference"}, "--solver=newton");
  ExpectRefused({"--contact=soft", "none"}, "--contact=soft");
  ExpectRefused({"--format=stl", "ply"}, "--format=stl");
  ExpectRefused({"--frames=2", "0 to 1"}, "--frames=2");
  ExpectRefused({"--frames=x"}, "--frames=x");
  ExpectRefused({"--frames=0:1:0"}, "--frames=0:1:0");
  ExpectRefused({"--threads"}, "--threads=-1");
  ExpectRefused({"threads"}, "--threads=many");
  ExpectRefused({"coarse_vertices", "3"}, "--coarse_vertices=3");
  ExpectRefused({"sample_spacing"}, "--sample_spacing=0");
  ExpectRefused({"solvr"}, "--solvr=ceres");
  ExpectRefused({"stray"}, "stray");
}

TEST_F(DeformProgram, RefusesAFolderThatCannotBeWritten) {
  WriteTextAtomically(dir_ + "/file", "text");
  WriteTextAtomically(dir_ + "/scene.json", scene_.dump());
  const ProgramRun run =
      Deform("--scene=" + dir_ + "/scene.json --out=" + dir_ + "/file/out");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.errors, HasSubstr("--out"));
  EXPECT_EQ(FileText(dir_ + "/file"), "text");
  EXPECT_EQ(Deform("--scene=" + dir_ + "/scene.json").exit_code, 2);
  EXPECT_EQ(Deform("--out=" + out()).exit_code, 2);
}

TEST_F(DeformProgram, HelpIsAboutThisProgramOnly) {
  const ProgramRun run = Deform("--help");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.out, AllOf(HasSubstr("--scene"), HasSubstr("--solver")));
  EXPECT_EQ(run.out.find("logtostderr"), std::string::npos);
}

TEST(DeformEmbeddedScene, IsUsableAndDoesNotDependOnThreads) {
  const std::string dir = TestTempDir();
  for (const char* threads : {"1", "2"}) {
    const ProgramRun run =
        Deform("--scene=" + EmbeddedScene() + " --out=" + dir + "/" + threads +
               " --threads=" + threads);
    ASSERT_EQ(run.exit_code, 0) << run.out << run.errors;
  }
  const Json report = Json::parse(FileText(dir + "/1/report.json"));
  EXPECT_LE(report["summary"]["worst_volume_error"], 1e-6);
  for (const Json& muscle : report["prepare"]["muscles"]) {
    EXPECT_TRUE(muscle["hull_encloses"]);
    // The planted defects were there and were repaired.
    EXPECT_NE(muscle["defects"], report["prepare"]["bones"][1]["defects"]);
  }
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(dir + "/1")) {
    if (entry.path().extension() != ".ply") continue;
    const fs::path other =
        dir / fs::path("2") / fs::relative(entry.path(), dir + "/1");
    EXPECT_EQ(FileText(entry.path()), FileText(other)) << other;
    ++files;
  }
  EXPECT_EQ(files, 30);  // five meshes at rest and in five poses
}

}  // namespace
}  // namespace musclewarp
