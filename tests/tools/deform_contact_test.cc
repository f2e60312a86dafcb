// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>

#include "musclewarp/base/output_file.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "support/meshes.h"
#include "support/temp_dir.h"
#include "tools/deform_program.h"

namespace musclewarp {
namespace {

using Json = nlohmann::json;
using ::testing::HasSubstr;

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
    EXPECT_LE(
        muscle["max_contact_displacement_mm"],
        std::max(2.5,
                 2 * muscle["depth_without_contact_mm"].get<double>() + 1));
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

// A bone along the axis of the upper end of the muscle, thinner than that where
// the bone begins: moving vertices does not separate them.
TriangleSoup BoneInTheEndOfTheMuscle() {
  return MovedBy(Spindle(7, 50, 3), {0, 3, 66});
}

TEST_F(DeformProgram, AMuscleThatCannotBeSeparatedIsMadeAnew) {
  WriteTriangleSoup(dir_ + "/bone.ply", BoneInTheEndOfTheMuscle());
  scene_["poses"] = Json::parse(R"([{"name": "rest"}])");
  const ProgramRun run = Run("--contact=certified");
  EXPECT_EQ(run.exit_code, 0) << run.out << run.errors;
  EXPECT_THAT(run.out, HasSubstr("made anew"));
  const Json report = Json::parse(FileText(out() + "/report.json"));
  const Json& muscle = report["prepare"]["muscles"][0];
  const Json& remade = muscle["remade"];
  ASSERT_TRUE(remade.is_object());
  EXPECT_EQ(remade["volume_after_mm3"], muscle["volume_mm3"]);
  // What the bone cuts off comes back beside it, to half a per cent, but for
  // what slivers take.
  const double before = remade["volume_before_mm3"];
  EXPECT_NEAR(remade["volume_after_mm3"], before, 0.01 * before);
  EXPECT_GT(remade["lost_area_mm2"], 0);
  EXPECT_GT(remade["farthest_mm"], 0);
  EXPECT_GT(remade["place_mm"][2], 22);
  EXPECT_THAT(report["prepare"]["warnings"].dump(),
              HasSubstr("muscle could not be separated"));
  // As it was delivered, and as it is now.
  EXPECT_GT(report["rest"]["intersections"]["triangle_pairs"], 0);
  EXPECT_EQ(report["rest"]["after_initial_fix"]["triangle_pairs"], 0);
  EXPECT_TRUE(report["frames"][0]["usable"])
      << report["frames"][0]["shortcomings"];
}

TEST_F(DeformProgram, NoMuscleIsMadeAnewIfThatIsNotWanted) {
  WriteTriangleSoup(dir_ + "/bone.ply", BoneInTheEndOfTheMuscle());
  ExpectRefused({"muscle crosses bone", "--remake=auto"},
                "--contact=certified --remake=never");
}

TEST_F(DeformProgram, SelfCrossingsAreRemovedAndCounted) {
  TriangleSoup soup = Spindle(12, 60, 3);
  soup.points.row(soup.triangles(200, 0))
      .swap(soup.points.row(soup.triangles(200, 1)));
  WriteMuscle(soup);
  scene_["poses"] = Json::parse(R"([{"name": "rest"}])");
  const auto prepared = [&](const std::string& contact) -> Json {
    const ProgramRun run = Run("--contact=" + contact);
    EXPECT_EQ(run.exit_code, 0) << run.out << run.errors;
    EXPECT_EQ(run.out.find("self-crossings removed") != std::string::npos,
              contact == "certified");
    return Json::parse(FileText(out() + "/report.json"))["prepare"];
  };
  const Json with = prepared("certified");
  const Json& muscle = with["muscles"][0];
  EXPECT_GT(muscle["repairs"]["self_crossing_pairs_before"], 0);
  EXPECT_EQ(muscle["repairs"]["self_crossing_pairs_after"], 0);
  EXPECT_GE(muscle["repairs"]["self_crossing_new_vertices"], 0);
  EXPECT_TRUE(muscle["remade"].is_null());
  EXPECT_EQ(with["bones"][0]["repairs"]["self_crossing_pairs_before"], 0);
  // Other kinds of contact keep the triangles of a mesh.
  const Json without = prepared("none");
  EXPECT_EQ(without["muscles"][0]["fine_vertices"], soup.points.rows());
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

}  // namespace
}  // namespace musclewarp
