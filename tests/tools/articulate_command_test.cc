// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/articulate_command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "joints/made_leg.h"
#include "musclewarp/base/input_file.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/opensim/kinematics.h"
#include "musclewarp/preparation/prepared_scene.h"
#include "musclewarp/program/program.h"
#include "musclewarp/scene/scene.h"
#include "page/packed_text.h"
#include "support/input_errors.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

// The meshes of a made leg as files, with a muscle beside the femur.
class ArticulateLeg : public ::testing::Test {
 protected:
  ArticulateLeg() : dir_(TestTempDir()), leg_(LegOf(Side::kRight)) {
    for (const Bone& bone : leg_.bones) Write(bone.name, bone.mesh);
    const TriangleSoup belly = Spindle(12, 60, 2);
    Write("vastus",
          MovedTo(belly, leg_.femur.head + Eigen::Vector3d(-120, -40, -200)));
    options_.out = dir_ + "/out";
    options_.muscles = Path("vastus");
  }

  void Write(const std::string& name, const TriangleSoup& soup) {
    WriteTriangleSoup(Path(name), soup);
  }
  std::string Path(const std::string& name) const {
    return dir_ + "/" + name + ".ply";
  }

  int Articulate(const std::vector<std::string>& names) {
    std::vector<std::string> files;
    for (const std::string& name : names) files.push_back(Path(name));
    std::ostringstream out;
    const int exit_code = ArticulateCommand(files, options_, out);
    screen_ = out.str();
    return exit_code;
  }

  void ExpectRefused(const std::vector<std::string>& words) {
    ExpectInputError([&] { Articulate({"femur", "tibia", "pelvis"}); }, words);
    EXPECT_FALSE(fs::exists(options_.out));
  }

  Json Report() const {
    return Json::parse(ReadFile(options_.out + "/joints.json"));
  }

  // What joints.html holds.
  std::string PageText() const {
    return PageJson(ReadFile(options_.out + "/joints.html"), "joints").dump();
  }

  const std::string dir_;
  const MadeLeg leg_;
  ArticulateOptions options_;
  std::string screen_;
};

TEST_F(ArticulateLeg, WritesASceneThatMoves) {
  options_.motion = "hip_flexion_r:-10:60:8,knee_angle_r:0:30";
  EXPECT_EQ(Articulate({"femur", "tibia", "pelvis"}), kExitUsable);
  EXPECT_THAT(screen_, HasSubstr("femur: a right femur, by its shape"));
  const Scene scene = ReadScene(options_.out + "/scene.json", {});
  ASSERT_EQ(scene.poses.size(), 8u);
  EXPECT_EQ(scene.muscles.size(), 1u);
  EXPECT_EQ(scene.bones.size(), 3u);
  EXPECT_NEAR(scene.poses[0].coordinates.at("hip_flexion_r"), -10, 1e-9);
  EXPECT_NEAR(scene.poses[7].coordinates.at("knee_angle_r"), 30, 1e-9);
  // The hip is a ball joint at the centre of the head.
  const Eigen::Matrix4d femur = scene.poses[7].bodies.at("femur_r");
  const Json hip = Report().at("joints").at(0);
  const Eigen::Vector4d center(
      hip["center_mm"][0], hip["center_mm"][1], hip["center_mm"][2], 1);
  EXPECT_LT((femur * center - center).norm(), 1e-6);  // mm
  EXPECT_TRUE(fs::exists(options_.out + "/Geometry/femur.obj"));
  EXPECT_TRUE(
      fs::exists(options_.out + "/motions/hip_flexion_r+knee_angle_r.mot"));
}

TEST_F(ArticulateLeg, WritesAMotionOfEachCoordinate) {
  EXPECT_EQ(Articulate({"femur", "tibia", "pelvis"}), kExitUsable);
  for (const char* name :
       {"hip_flexion_r", "hip_adduction_r", "hip_rotation_r", "knee_angle_r"}) {
    EXPECT_TRUE(fs::exists(options_.out + "/motions/" + name + ".mot")) << name;
  }
}

// The lines are those that musclewarp-deform makes.
TEST_F(ArticulateLeg, WritesTheLinesOfMusclesIntoTheModel) {
  EXPECT_EQ(Articulate({"femur", "tibia", "pelvis"}), kExitUsable);
  EXPECT_THAT(screen_, HasSubstr("model.osim has 3 muscles"));
  EXPECT_THAT(screen_, HasSubstr("are estimates"));
  const Model model = ReadModel(options_.out + "/model.osim");
  const auto ground_from_body = BodyFrames(model, DefaultValues(model));
  PrepareOptions prepare;
  prepare.remove_self_crossings = prepare.remove_slivers = true;
  const PreparedScene prepared =
      PrepareScene(ReadScene(options_.out + "/scene.json", {}), prepare);
  const std::vector<ActionLine>& lines = prepared.scene.muscles[0].lines;
  ASSERT_EQ(model.muscles.size(), lines.size());
  for (size_t m = 0; m < lines.size(); ++m) {
    EXPECT_EQ(model.muscles[m].name, lines[m].name);
    const std::vector<PathPoint>& path = model.muscles[m].path;
    ASSERT_EQ(path.size(), static_cast<size_t>(lines[m].rest.rows()));
    for (size_t i = 0; i < path.size(); ++i) {
      EXPECT_EQ(model.bodies[path[i].body].name, lines[m].bodies[i]);
      const Eigen::Vector4d place =
          ground_from_body[path[i].body] * path[i].location.homogeneous();
      EXPECT_LT((place.head<3>() - lines[m].rest.row(i).transpose()).norm(),
                1e-6);  // mm
    }
  }
}

TEST_F(ArticulateLeg, WritesAModelWithoutMusclesIfThereAreNone) {
  options_.muscles.clear();
  EXPECT_EQ(Articulate({"femur", "tibia", "pelvis"}), kExitUsable);
  EXPECT_THAT(screen_, Not(HasSubstr("model.osim")));
  EXPECT_TRUE(ReadModel(options_.out + "/model.osim").muscles.empty());
}

// Of a mesh whose volume is none, no lines can be made.
TEST_F(ArticulateLeg, SaysWhyTheModelHasNoMuscles) {
  TriangleSoup sheet = Box(30, 30, 30);
  sheet.points.col(1).setConstant(-40);
  Write("vastus", sheet);
  EXPECT_EQ(Articulate({"femur", "tibia", "pelvis"}), kExitUsable);
  EXPECT_THAT(screen_, HasSubstr("warning: model.osim has no muscles"));
  EXPECT_THAT(screen_, HasSubstr("vastus"));
  EXPECT_TRUE(ReadModel(options_.out + "/model.osim").muscles.empty());
}

TEST_F(ArticulateLeg, WarnsOfNamesThatOpenSimRefuses) {
  fs::rename(Path("vastus"), Path("vastus lateralis"));
  options_.muscles = Path("vastus lateralis");
  EXPECT_EQ(Articulate({"femur", "tibia", "pelvis"}), kExitUsable);
  EXPECT_THAT(screen_, HasSubstr("refuse \"vastus lateralis_1\""));
  EXPECT_GE(
      ReadModel(options_.out + "/model.osim").FindMuscle("vastus lateralis_1"),
      0);
}

TEST_F(ArticulateLeg, WritesAPageIfAskedTo) {
  Articulate({"femur", "tibia", "pelvis"});
  EXPECT_FALSE(fs::exists(options_.out + "/joints.html"));
  options_.html = true;
  Articulate({"femur", "tibia", "pelvis"});
  EXPECT_THAT(PageText(), HasSubstr("hip_flexion_r"));
  EXPECT_THAT(screen_, HasSubstr("joints.html"));
}

TEST_F(ArticulateLeg, MayBeMovedTogetherWithItsMeshes) {
  options_.html = true;
  Articulate({"femur", "tibia", "pelvis"});
  EXPECT_THAT(PageText(), Not(HasSubstr(dir_.substr(1))));
  for (const char* file : {"scene.json", "joints.json", "joints.html"}) {
    EXPECT_THAT(ReadFile(options_.out + "/" + file),
                Not(HasSubstr(dir_.substr(1))))
        << file;
  }
  const std::string out = fs::relative(options_.out, dir_).string();
  const std::string moved = dir_ + "/moved";
  fs::create_directories(moved);
  for (const auto& entry : fs::directory_iterator(dir_)) {
    const std::string name = entry.path().filename().string();
    if (name != "moved") fs::rename(entry.path(), moved + "/" + name);
  }
  const Scene scene = ReadScene(moved + "/" + out + "/scene.json", {});
  EXPECT_EQ(scene.bones.size(), 3u);
}

TEST_F(ArticulateLeg, TakesACorrectedJointBack) {
  Articulate({"femur", "tibia", "pelvis"});
  Json report = Report();
  for (Json& joint : report["joints"]) {
    if (joint["name"] == "knee_r") joint["center_mm"] = {1, 2, 3};
  }
  options_.given = dir_ + "/given.json";
  WriteTextAtomically(options_.given, report.dump());
  EXPECT_EQ(Articulate({"femur", "tibia", "pelvis"}), kExitUsable);
  for (const Json& joint : Report().at("joints")) {
    EXPECT_TRUE(joint.at("given"));
    if (joint.at("name") == "knee_r") {
      EXPECT_EQ(joint.at("center_mm"), Json({1.0, 2.0, 3.0}));
    }
  }
}

TEST_F(ArticulateLeg, SaysSoIfAJointFails) {
  Write("femur", MovedTo(leg_.bones[0].mesh, {0, 0, -200}));
  options_.joints = "hip";
  EXPECT_EQ(Articulate({"femur", "tibia", "pelvis"}), kExitNotUsable);
  EXPECT_THAT(screen_, HasSubstr("hip_r       failed"));
  EXPECT_THAT(screen_, HasSubstr("bones from two scans"));
}

TEST_F(ArticulateLeg, KeepsBonesThatItDoesNotKnow) {
  Write("thing", Box(20, 20, 20));
  EXPECT_EQ(Articulate({"femur", "tibia", "pelvis", "thing"}), kExitUsable);
  EXPECT_THAT(screen_, HasSubstr("thing: not known as a bone"));
  EXPECT_EQ(ReadScene(options_.out + "/scene.json", {}).bones.size(), 4u);
}

TEST_F(ArticulateLeg, DoesNotReplaceItsInput) {
  Articulate({"femur", "tibia", "pelvis"});
  const std::string femur = options_.out + "/Geometry/femur.obj";
  const std::string before = ReadFile(femur);
  options_.units = "cm";
  std::ostringstream screen;
  ExpectInputError(
      [&] {
        ArticulateCommand(
            {femur, Path("tibia"), Path("pelvis")}, options_, screen);
      },
      {"--out=", "femur.obj", "would be replaced"});
  EXPECT_EQ(ReadFile(femur), before);
}

TEST_F(ArticulateLeg, RefusesBadFlags) {
  options_.motion = "hip_flexion_r:-10";
  ExpectRefused({"--motion=hip_flexion_r:-10", "COORDINATE:FROM:TO:FRAMES"});
  options_.motion = "hip_flexion_r:0:x:5";
  ExpectRefused({"--motion", "\"x\"", "no number"});
  options_.motion = "hip_flexion_r:0:10:0";
  ExpectRefused({"frames", "1 to 100000"});
  options_.motion = "hip_flexion_r:0:10:5,hip_flexion_r:0:20:5";
  ExpectRefused({"--motion", "\"hip_flexion_r\" a second time"});
  options_.motion = "hip_flexion_r:0:1e300:5";
  ExpectRefused({"--motion", "\"1e300\" degrees", "-360 to 360"});
  options_.motion = "hip_flexion_r:0:10:1";
  ExpectRefused({"--motion", "\"hip_flexion_r\" in one frame"});
  options_.motion = "hip_flexion_l:0:10:5";
  ExpectRefused({"--motion", "hip_flexion_l", "hip_flexion_r"});
  options_.motion.clear();
  options_.joints = "hipp";
  ExpectRefused({"--joints", "hipp", "hip, knee"});
  options_.joints = "elbow";
  ExpectRefused({"joint elbow", "lacks its bones"});
  options_.joints.clear();
  options_.side = "up";
  ExpectRefused({"--side=up", "right, left, both"});
  options_.side = "both";
  options_.axes = "LLS";
  ExpectRefused({"--axes=LLS", "LPS"});
  options_.axes = "RPS";
  ExpectRefused({"--axes=RPS", "left-handed"});
  options_.axes = "LPS";
  options_.zero = "now";
  ExpectRefused({"--zero=now", "anatomy, scan"});
  options_.zero = "scan";
  options_.given = dir_ + "/none.json";
  ExpectRefused({"none.json"});
  options_.given.clear();
  options_.edge = -1;
  ExpectRefused({"--edge", "is -1", "0 to 100, mm"});
  options_.edge = 0;
  options_.muscles = Path("femur");
  ExpectRefused({"femur.ply", "has the name"});
}

}  // namespace
}  // namespace musclewarp
