// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>

#include "musclewarp/base/output_file.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "support/meshes.h"
#include "support/temp_dir.h"
#include "tools/run_program.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;

ProgramRun Deform(const std::string& arguments) {
  // Most are not about contact; flags that come later win.
  return RunCommandLine(MUSCLEWARP_DEFORM, "--contact=none " + arguments);
}

std::string EmbeddedScene() {
  return std::string(MUSCLEWARP_DATA_DIR) + "/phantom/scene.json";
}

// A scene of one spindle and one bone in the folder of the test.
class DeformProgram : public ::testing::Test {
 protected:
  DeformProgram() : dir_(TestTempDir()) {
    TriangleSoup bone = Icosphere(10, 2);
    bone.points.rowwise() += Eigen::RowVector3d(22, 0, 30);
    WriteTriangleSoup(dir_ + "/muscle.ply", Spindle(12, 60, 3));
    WriteTriangleSoup(dir_ + "/bone.ply", bone);
    scene_ = Json::parse(R"({"name": "spindle", "units": "mm",
      "muscles": [{"name": "muscle", "mesh": "muscle.ply", "lines":
        [{"name": "line", "rest": [[0,0,-55],[0,0,0],[0,0,55]]}]}],
      "bones": [{"name": "bone", "mesh": "bone.ply", "body": "bone"}],
      "poses": [{"name": "rest"}, {"name": "bent", "lines":
        {"line": [[0,0,-55],[0,0,0],[30,0,45]]}}]})");
  }

  ProgramRun Run(const std::string& flags = "") {
    WriteTextAtomically(dir_ + "/scene.json", scene_.dump());
    return Deform("--scene=" + dir_ + "/scene.json --out=" + out() + " " +
                  flags);
  }

  std::string out() const { return dir_ + "/out"; }

  // Exit code 2, all words in the message, nothing written.
  void ExpectRefused(const std::vector<std::string>& words,
                     const std::string& flags = "") {
    const ProgramRun run = Run(flags);
    EXPECT_EQ(run.exit_code, 2) << run.out << run.errors;
    for (const auto& word : words) EXPECT_THAT(run.errors, HasSubstr(word));
    EXPECT_FALSE(fs::exists(out()));
  }

  void WriteMuscle(const TriangleSoup& soup) {
    WriteTriangleSoup(dir_ + "/muscle.ply", soup);
  }

  const std::string dir_;
  Json scene_;
};

TEST_F(DeformProgram, CertifiedContactHoldsOnOverlappingMeshes) {
  TriangleSoup bone = Icosphere(10, 2);
  bone.points.rowwise() += Eigen::RowVector3d(17, 0, 20);
  WriteTriangleSoup(dir_ + "/bone.ply", bone);
  scene_["poses"][1]["lines"]["line"] =
      Json::parse("[[0,0,-55],[0,0,0],[6,0,54.5]]");
  const ProgramRun run = Run("--contact=certified");
  EXPECT_EQ(run.exit_code, 0) << run.out << run.errors;
  const Json report = Json::parse(FileText(out() + "/report.json"));
  EXPECT_EQ(report["contact"], "certified");
  EXPECT_GT(report["rest"]["intersections"]["triangle_pairs"], 0);
  EXPECT_EQ(report["rest"]["after_initial_fix"]["triangle_pairs"], 0);
  for (const Json& frame : report["frames"]) {
    EXPECT_TRUE(frame["shortcomings"].empty()) << frame["shortcomings"];
    EXPECT_EQ(frame["intersections"]["triangle_pairs"], 0);
    EXPECT_EQ(frame["intersections"]["vertices_inside"], 0);
    const Json& muscle = frame["muscles"][0];
    EXPECT_NEAR(muscle["volume_ratio"], 1, 1e-6);
    EXPECT_GT(muscle["max_contact_displacement_mm"], 0);
    EXPECT_LE(muscle["max_contact_displacement_mm"],
              2 * muscle["depth_without_contact_mm"].get<double>() + 1);
  }
}

TEST_F(DeformProgram, ContactIsCertifiedUnlessSaidOtherwise) {
  WriteTextAtomically(dir_ + "/scene.json", scene_.dump());
  const ProgramRun run = RunCommandLine(
      MUSCLEWARP_DEFORM,
      "--frames=0 --scene=" + dir_ + "/scene.json --out=" + out());
  EXPECT_EQ(run.exit_code, 0) << run.out << run.errors;
  EXPECT_EQ(Json::parse(FileText(out() + "/report.json"))["contact"],
            "certified");
}

TEST_F(DeformProgram, WhatMayPenetrateIsLeftAndCountedApart) {
  // The end of the spindle, 8 mm in a bone.
  TriangleSoup bone = Icosphere(10, 2);
  bone.points.rowwise() += Eigen::RowVector3d(0, 0, 62);
  WriteTriangleSoup(dir_ + "/bone.ply", bone);
  scene_["poses"] = Json::parse(R"([{"name": "rest"}])");
  scene_["muscles"][0]["attachments"] = Json::parse(
      R"([{"body": "bone", "points": [[0, 0, 60]], "radius": 14}])");
  const auto intersections = [&](bool may_penetrate) -> Json {
    scene_["muscles"][0]["attachments"][0]["may_penetrate"] = may_penetrate;
    const ProgramRun run = Run("--contact=certified");
    EXPECT_EQ(run.exit_code, 0) << run.out << run.errors;
    const Json report = Json::parse(FileText(out() + "/report.json"));
    const Json& frame = report["frames"][0];
    EXPECT_TRUE(frame["usable"]) << frame["shortcomings"];
    EXPECT_EQ(frame["intersections"]["triangle_pairs"], 0);
    EXPECT_EQ(frame["intersections"]["vertices_inside"], 0);
    return frame["intersections"];
  };
  EXPECT_EQ(intersections(false)["exempt_pairs"], 0);
  const Json exempt = intersections(true);
  EXPECT_GT(exempt["exempt_pairs"], 10);
  EXPECT_EQ(exempt["pairs"][0]["exempt_pairs"], exempt["exempt_pairs"]);
}

TEST_F(DeformProgram, SaysWhereAMuscleHasNoRoom) {
  // Two bones that meet in the middle of the muscle.
  TriangleSoup bone = Icosphere(40, 3);
  bone.points.rowwise() += Eigen::RowVector3d(60, 0, 0);
  WriteTriangleSoup(dir_ + "/right.ply", bone);
  bone.points.rowwise() -= Eigen::RowVector3d(120, 0, 0);
  WriteTriangleSoup(dir_ + "/left.ply", bone);
  scene_["bones"] = Json::parse(R"([
    {"name": "right", "mesh": "right.ply", "body": "right"},
    {"name": "left", "mesh": "left.ply", "body": "left"}])");
  scene_["poses"] = Json::parse(R"([{"name": "rest"}, {"name": "squeezed",
    "bodies": {"right": [[1,0,0,-21],[0,1,0,0],[0,0,1,0],[0,0,0,1]],
               "left": [[1,0,0,21],[0,1,0,0],[0,0,1,0],[0,0,0,1]]}}])");
  const ProgramRun run = Run("--contact=certified");
  EXPECT_EQ(run.exit_code, 1) << run.out << run.errors;
  const Json report = Json::parse(FileText(out() + "/report.json"));
  EXPECT_FALSE(report["summary"]["usable"]);
  EXPECT_TRUE(report["frames"][0]["usable"])
      << report["frames"][0]["shortcomings"];
  EXPECT_FALSE(report["frames"][1]["usable"]);
  const std::string why = report["frames"][1]["shortcomings"].dump();
  EXPECT_THAT(why, HasSubstr("muscle"));
  // Where they meet.
  std::smatch place;
  ASSERT_TRUE(std::regex_search(
      why,
      place,
      std::regex(
          R"(triangle pairs around \(([-0-9.]+), ([-0-9.]+), ([-0-9.]+)\))")))
      << why;
  for (int k = 1; k <= 3; ++k) EXPECT_LT(std::abs(std::stod(place[k])), 5);
}

TEST(DeformEmbeddedScene, CertifiedContactDoesNotDependOnThreads) {
  const std::string scene = "--scene=" MUSCLEWARP_DATA_DIR
                            "/phantom/motion.json --contact=certified ";
  const std::string dir = TestTempDir();
  const auto positions = [&](const std::string& out) {
    return ReadTriangleSoup(out + "/frame_0000/gluteus_medius_r.ply").points;
  };
  EXPECT_EQ(Deform(scene + "--frames=0 --out=" + dir + "/whole").exit_code, 0);
  EXPECT_EQ(
      Deform(scene + "--frames=0 --threads=1 --out=" + dir + "/one_thread")
          .exit_code,
      0);
  EXPECT_EQ(positions(dir + "/whole"), positions(dir + "/one_thread"));
}

}  // namespace

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

TEST_F(DeformProgram, PaperContactPushesTheMuscleOffTheBone) {
  for (const char* level : {"coarse", "fine"}) {
    for (const char* solver : {"reference", "ceres"}) {
      const ProgramRun run =
          Run(std::string("--contact=paper --contact_level=") + level +
              " --solver=" + solver);
      ASSERT_EQ(run.exit_code, 0) << run.out << run.errors;
      const Json report = Json::parse(FileText(out() + "/report.json"));
      EXPECT_EQ(report["contact"], "paper");
      EXPECT_EQ(report["contact_options"]["level"], level);
      EXPECT_TRUE(report["rest"].contains("after_initial_fix"));
      const Json& frame = report["frames"][1];
      EXPECT_EQ(frame["intersections"]["vertices_inside"], 0)
          << level << " " << solver;
      EXPECT_NEAR(frame["muscles"][0]["volume_ratio"], 1, 1e-6);
    }
  }
}

TEST_F(DeformProgram, PaperContactIsTheSameToTheByteForEveryNumberOfThreads) {
  const auto written = [&](const std::string& flags) {
    EXPECT_EQ(Run("--contact=paper " + flags).exit_code, 0);
    return FileText(out() + "/frame_0001/muscle.ply");
  };
  const std::string once = written("--threads=1 --seed=3");
  EXPECT_EQ(once, written("--threads=1 --seed=3"));
  EXPECT_EQ(once, written("--threads=3 --seed=3"));
}

TEST_F(DeformProgram, AnswersForMeshesThatContainEachOther) {
  // A bone inside the muscle; then a second muscle inside the first; then the
  // same mesh twice. Counted, said, never a hang or crash.
  WriteTriangleSoup(dir_ + "/bone.ply", Icosphere(4, 2));
  ProgramRun run = Run("--contact=paper --frames=0");
  EXPECT_LE(run.exit_code, 1) << run.errors;
  EXPECT_THAT(run.errors, HasSubstr("bone lies inside muscle"));

  scene_["bones"] = Json::array();
  scene_["muscles"].push_back(scene_["muscles"][0]);
  scene_["muscles"][1]["name"] = "inner";
  scene_["muscles"][1]["mesh"] = "inner.ply";
  scene_["muscles"][1]["lines"][0]["name"] = "inner_line";
  WriteTriangleSoup(dir_ + "/inner.ply", Spindle(4, 40, 3));
  run = Run("--contact=paper --frames=0");
  EXPECT_LE(run.exit_code, 1) << run.errors;
  EXPECT_THAT(run.errors, HasSubstr("inner lies inside muscle"));

  WriteTriangleSoup(dir_ + "/inner.ply", Spindle(12, 60, 3));
  run = Run("--contact=paper --frames=0");
  EXPECT_LE(run.exit_code, 1) << run.errors;
  EXPECT_THAT(run.errors, HasSubstr("muscle and inner are the same mesh"));
}

TEST_F(DeformProgram, RefusesAnObstacleThatIsNotClosed) {
  TriangleSoup open = Icosphere(10, 2);
  open.triangles = open.triangles.topRows(200).eval();
  WriteTriangleSoup(dir_ + "/bone.ply", open);
  ExpectRefused({"bone.ply", "hole"}, "--contact=paper");
}

TEST_F(DeformProgram, SelectsFrames) {
  ASSERT_EQ(Run("--frames=last").exit_code, 0);
  EXPECT_FALSE(fs::exists(out() + "/frame_0000"));
  EXPECT_TRUE(fs::exists(out() + "/frame_0001"));
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
  EXPECT_EQ(Json::parse(FileText(out() + "/report.json"))["prepare"]["warnings"]
                .size(),
            1u);
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

}  // namespace musclewarp
