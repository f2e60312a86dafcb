// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "musclewarp/base/output_file.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "support/meshes.h"
#include "support/temp_dir.h"
#include "tools/run_program.h"

namespace musclewarp {
namespace {

using Json = nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

ProgramRun Check(const std::string& arguments) {
  return RunCommandLine(MUSCLEWARP_CHECK, arguments);
}

}  // namespace

TEST(CheckProgram, FindsAKnownOverlap) {
  const std::string dir = TestTempDir();
  TriangleSoup small = Box(1, 1, 1);
  WriteTriangleSoup(dir + "/large.ply", Box(10, 10, 10));
  WriteTriangleSoup(dir + "/inside.obj", small);
  small.points.rowwise() += Eigen::RowVector3d(5.2, 0, 0);
  WriteTriangleSoup(dir + "/across.off", small);
  small.points.rowwise() += Eigen::RowVector3d(5, 0, 0);
  WriteTriangleSoup(dir + "/apart.stl", small);
  const ProgramRun run =
      Check(dir + "/large.ply " + dir + "/inside.obj " + dir + "/across.off " +
            dir + "/apart.stl --json=" + dir + "/check.json");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.out, HasSubstr("2 of 6 pairs of meshes touch, 4 are apart"));
  const Json json = Json::parse(FileText(dir + "/check.json"));
  ASSERT_EQ(json["pairs"].size(), 6u);
  const Json& inside = json["pairs"][0];
  EXPECT_EQ(inside["triangle_pairs"], 0);
  EXPECT_EQ(inside["b_vertices_inside_a"], 8);
  EXPECT_NEAR(inside["max_depth_mm"], 4.5, 1e-12);
  const Json& across = json["pairs"][1];
  EXPECT_GT(across["triangle_pairs"], 0);
  EXPECT_EQ(across["b_vertices_inside_a"], 4);
  EXPECT_NEAR(across["max_depth_mm"], 0.3, 1e-12);
  EXPECT_NEAR(json["files"][0]["volume_mm3"], 1000, 1e-9);
  EXPECT_TRUE(json["files"][0]["clean"]);
}

TEST(CheckProgram, FilesOfAnotherSpaceAreTurned) {
  const std::string dir = TestTempDir();
  const std::string faces = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
  WriteTextAtomically(
      dir + "/a.obj",
      "# SPACE=LPS\nv 20 30 0\nv 29 30 0\nv 20 39 0\nv 20 30 9\n" + faces);
  WriteTextAtomically(dir + "/b.obj",
                      "# SPACE=RAS\nv -20 -30 0\nv -29 -30 0\nv -20 -39 0\n"
                      "v -20 -30 9\n" +
                          faces);
  const ProgramRun run = Check(dir + "/a.obj " + dir + "/b.obj");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.out,
              AllOf(HasSubstr("b.obj states the space RAS"),
                    HasSubstr("1 of 1 pairs of meshes touch")));
}

TEST(CheckProgram, ReportsDefectsWithoutRepair) {
  const std::string dir = TestTempDir();
  TriangleSoup soup = Icosphere(10, 2);
  soup.triangles.conservativeResize(soup.triangles.rows() - 1, 3);
  WriteTriangleSoup(dir + "/open.ply", soup);
  const ProgramRun run = Check(dir + "/open.ply --json=" + dir + "/check.json");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.out, HasSubstr("3 border edges"));
  const Json json = Json::parse(FileText(dir + "/check.json"));
  EXPECT_FALSE(json["files"][0]["closed_manifold"]);
  EXPECT_EQ(json["files"][0]["defects"]["border_edges"], 3);
  EXPECT_EQ(json["files"][0]["triangles"], soup.triangles.rows());
}

TEST(CheckProgram, AMeshThatIsNotOrientedHasNoVolume) {
  const std::string dir = TestTempDir();
  const TriangleSoup box = Box(10, 10, 10);
  TriangleSoup turned = box;
  turned.triangles.row(0).reverseInPlace();
  const auto check = [&](const TriangleSoup& soup) {
    WriteTriangleSoup(dir + "/box.ply", soup);
    return Check(dir + "/box.ply --json=" + dir + "/check.json").out;
  };
  const auto is_oriented = [&] {
    const Json json = Json::parse(FileText(dir + "/check.json"));
    return json["files"][0]["oriented"].get<bool>();
  };
  EXPECT_THAT(check(box), HasSubstr("        1.00           0  none"));
  EXPECT_TRUE(is_oriented());
  EXPECT_THAT(check(turned), HasSubstr("           -           0  "));
  EXPECT_FALSE(is_oriented());
}

TEST(CheckProgram, SaysWhatAReaderSkipped) {
  const std::string dir = TestTempDir();
  WriteTriangleSoup(dir + "/a.obj", Box(1, 1, 1));
  WriteTextAtomically(dir + "/a.obj", FileText(dir + "/a.obj") + "vw 1 0\n");
  const ProgramRun run = Check(dir + "/a.obj --json=" + dir + "/check.json");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.out, HasSubstr("no OBJ statement was skipped: 'vw'"));
  const Json json = Json::parse(FileText(dir + "/check.json"));
  EXPECT_EQ(json["notes"].size(), 1u);
}

TEST(CheckProgram, CanRequireCleanMeshes) {
  const std::string dir = TestTempDir();
  WriteTriangleSoup(dir + "/a.ply", Box(1, 1, 1));
  WriteTriangleSoup(dir + "/b.ply", Box(2, 2, 0.5));
  const std::string files = dir + "/a.ply " + dir + "/b.ply";
  EXPECT_EQ(Check(files).exit_code, 0);
  EXPECT_EQ(Check(files + " --require_clean").exit_code, 1);
}

// Bones stay where they are delivered, named among the files or beside them.
TEST(CheckProgram, BonesMayCrossEachOther) {
  const std::string dir = TestTempDir();
  WriteTriangleSoup(dir + "/hip_bone.ply", Box(1, 1, 1));
  WriteTriangleSoup(dir + "/sacrum.ply", Box(2, 2, 0.5));
  WriteTriangleSoup(dir + "/psoas.ply", MovedBy(Box(1, 1, 1), {5, 0, 0}));
  const std::string all = dir + "/hip_bone.ply " + dir + "/psoas.ply " + dir +
                          "/sacrum.ply --require_clean --gap=0.1";
  EXPECT_EQ(Check(all).exit_code, 1);
  EXPECT_EQ(Check(all + " --bone=sacrum").exit_code, 1);
  const ProgramRun run = Check(all + " --bone=hip_bone,sacrum");
  EXPECT_EQ(run.exit_code, 0) << run.out << run.errors;
  EXPECT_THAT(run.out, HasSubstr("hip_bone and sacrum are bones"));
  EXPECT_EQ(Check(dir + "/psoas.ply --require_clean --bone=" + dir +
                  "/hip_bone.ply," + dir + "/sacrum.ply")
                .exit_code,
            0);
}

TEST(CheckProgram, FilesMayBeInMetres) {
  const std::string dir = TestTempDir();
  WriteTriangleSoup(dir + "/a.ply", Box(0.1, 0.1, 0.1));
  ASSERT_EQ(
      Check(dir + "/a.ply --units=m --json=" + dir + "/check.json").exit_code,
      0);
  const Json json = Json::parse(FileText(dir + "/check.json"));
  EXPECT_NEAR(json["files"][0]["volume_mm3"], 1e6, 1e-3);
  EXPECT_EQ(Check(dir + "/a.ply --units=inch").exit_code, 2);
}

TEST(CheckProgram, AsksForTheUnitOfWhatIsTooSmall) {
  const std::string dir = TestTempDir();
  WriteTriangleSoup(dir + "/a.ply", Box(0.1, 0.1, 0.1));
  WriteTriangleSoup(dir + "/b.ply", Box(100, 100, 100));
  const ProgramRun run = Check(dir + "/a.ply " + dir + "/b.ply");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.out, HasSubstr("a.ply is 0.173 mm across"));
  EXPECT_THAT(run.out, HasSubstr("is it in metres?"));
  EXPECT_THAT(run.out, Not(HasSubstr("b.ply is")));
}

TEST(CheckProgram, MeasuresDistancesAndCanRequireAGap) {
  const std::string dir = TestTempDir();
  WriteTriangleSoup(dir + "/a.ply", Box(1, 1, 1));
  WriteTriangleSoup(dir + "/b.ply", MovedBy(Box(1, 1, 1), {1.25, 0.5, 0}));
  WriteTriangleSoup(dir + "/inside.ply", Box(0.5, 0.5, 0.5));
  const std::string files = dir + "/a.ply " + dir + "/b.ply";
  ProgramRun run = Check(files + " --json=" + dir + "/check.json --gap=0.25");
  EXPECT_EQ(run.exit_code, 0) << run.out << run.errors;
  EXPECT_THAT(run.out, HasSubstr("0.25\n"));
  EXPECT_THAT(run.out,
              HasSubstr("0 of 1 pairs of meshes are less than 0.25 mm apart"));
  EXPECT_EQ(
      Json::parse(FileText(dir + "/check.json"))["pairs"][0]["distance_mm"],
      0.25);
  run = Check(files + " --gap=0.26");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.out,
              HasSubstr("1 of 1 pairs of meshes are less than 0.26 mm apart"));
  // What lies inside is not apart, however far the surfaces are.
  EXPECT_EQ(Check(dir + "/a.ply " + dir + "/inside.ply --gap=0.01").exit_code,
            1);
  run = Check(files + " --gap=-1");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.errors, HasSubstr("--gap: is -1; allowed: 0 or above, mm"));
}

TEST(CheckProgram, RefusesBadInput) {
  const std::string dir = TestTempDir();
  EXPECT_EQ(Check("").exit_code, 2);
  const ProgramRun missing =
      Check(dir + "/nothing.ply --json=" + dir + "/check.json");
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_THAT(missing.errors,
              AllOf(HasSubstr("musclewarp-check"), HasSubstr("nothing.ply")));
  EXPECT_FALSE(std::filesystem::exists(dir + "/check.json"));
  WriteTriangleSoup(dir + "/a.ply", Box(1, 1, 1));
  EXPECT_EQ(Check(dir + "/a.ply --unknown=1").exit_code, 2);
  EXPECT_EQ(Check(dir + "/a.ply --json=" + dir + "/no/folder.json").exit_code,
            2);
}

}  // namespace musclewarp
