// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "musclewarp/base/angles.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/scene/line_targets.h"
#include "musclewarp/scene/path_moment_arms.h"
#include "musclewarp/scene/scene.h"
#include "scene/transform_checks.h"
#include "support/input_errors.h"
#include "support/osim_models.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

using Json = nlohmann::json;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

const Eigen::Vector3d kKnee(0, -400, 0);

// A leg whose knee turns about z, with a muscle from thigh to shank.
class ModelScene : public ::testing::Test {
 protected:
  void SetUp() override {
    dir_ = TestTempDir();
    model_ = Model4(Joint4("PinJoint", "knee"),
                    "",
                    Muscle("m",
                           Point4("p1", "thigh", "0.02 -0.1 0") +
                               Point4("p2",
                                      "thigh",
                                      "0.05 -0.4 0",
                                      "ConditionalPathPoint",
                                      "<socket_coordinate>knee"
                                      "</socket_coordinate><range>-2 -0.3"
                                      "</range>") +
                               Point4("p3", "shank", "0.03 -0.1 0")));
    motion_ = "m\ninDegrees=yes\nendheader\ntime knee\n0 0\n0.1 -30\n0.2 -60\n";
    scene_ = Json::parse(R"({"name": "leg", "units": "mm",
      "muscles": [{"name": "muscle", "mesh": "m.ply", "lines": ["m",
        {"name": "own", "rest": [[0,-300,0],[0,-500,0]],
         "bodies": ["thigh", "shank"]}]}],
      "bones": [{"name": "thigh", "mesh": "t.ply", "body": "thigh"},
                {"name": "shank", "mesh": "s.ply", "body": "shank"}],
      "model": "leg.osim", "motion": "leg.mot",
      "model_rest": {"coordinates": {"knee": -20}, "in_degrees": true}})");
  }

  Scene Read(const std::string& motion = "") {
    WriteTextAtomically(dir_ + "/leg.osim", model_);
    WriteTextAtomically(dir_ + "/leg.mot", motion_);
    WriteTextAtomically(dir_ + "/scene.json", scene_.dump());
    return ReadScene(dir_ + "/scene.json", "", {motion});
  }

  void ExpectRefused(const std::vector<std::string>& words) {
    ExpectInputError([&] { Read(); }, words);
  }

  // Turned about the knee by so many degrees.
  static Eigen::Vector3d Turned(const Eigen::Vector3d& point, double degrees) {
    return kKnee +
           Eigen::AngleAxisd(RadiansOf(degrees), Eigen::Vector3d::UnitZ()) *
               (point - kKnee);
  }

  std::string dir_, model_, motion_;
  Json scene_;
};

// Of a model with a ball whose joint has a coordinate "knee", too.
TEST_F(ModelScene, AColumnThatNamesTwoCoordinatesMattersWhereItIsNeeded) {
  model_ = Replaced(model_,
                    "<Body name=\"shank\"",
                    "<Body name=\"ball\"/><Body name=\"shank\"");
  model_ = Replaced(model_,
                    "<PinJoint name=\"knee_joint\">",
                    "<PinJoint name=\"other\"><socket_parent_frame>/ground"
                    "</socket_parent_frame><socket_child_frame>/bodyset/ball"
                    "</socket_child_frame><coordinates><Coordinate "
                    "name=\"knee\"/></coordinates></PinJoint>"
                    "<PinJoint name=\"knee_joint\">");
  model_ = Replaced(model_,
                    "<socket_coordinate>knee",
                    "<socket_coordinate>/jointset/knee_joint/knee");
  scene_["model_rest"]["coordinates"] = {{"knee_joint/knee", -20}};
  ExpectRefused({"leg.mot", "no column", "other/knee, knee_joint/knee"});
  motion_ = Replaced(motion_, "time knee", "time /jointset/knee_joint/knee");
  EXPECT_NEAR(Read().poses[1].coordinates.at("knee_joint/knee"),
              -30,
              kTransformRounding);
  // Beside a column that says all, the other one is of the ball.
  motion_ =
      "m\ninDegrees=yes\nendheader\n"
      "time /jointset/knee_joint/knee knee\n0 0 5\n0.1 -30 6\n";
  EXPECT_THAT(Read().warnings,
              Contains(HasSubstr("column \"knee\" is the name of 2")));
  motion_ =
      Replaced(motion_, "/jointset/knee_joint/knee", "/jointset/other/knee");
  ExpectRefused(
      {"\"knee\", which may mean knee_joint/knee, and this moves shank",
       "/jointset/knee_joint/knee/value"});
}

TEST_F(ModelScene, BodiesTurnFromTheRestPoseToThePose) {
  const Scene scene = Read();
  ASSERT_EQ(scene.poses.size(), 3u);
  EXPECT_TRUE(scene.is_motion);
  EXPECT_EQ(scene.poses[1].name, "t=0.1");
  EXPECT_NEAR(scene.poses[1].coordinates.at("knee"), -30, 1e-12);
  const Eigen::Vector3d point(10, -500, 7);
  const Points moved =
      Transformed(point.transpose(), BodyTransform(scene.poses[2], "shank"));
  // Rest was at -20, so -60 is 40 on.
  EXPECT_LT((moved.row(0).transpose() - Turned(point, -40)).norm(),
            kTransformRounding);
  EXPECT_LT(
      (BodyTransform(scene.poses[2], "thigh") - Eigen::Matrix4d::Identity())
          .norm(),
      kTransformRounding);
}

TEST_F(ModelScene, LinesAreThePathsWithConditionalPoints) {
  const Scene scene = Read();
  const ActionLine& line = scene.muscles[0].lines[0];
  ASSERT_EQ(line.rest.rows(), 3);
  EXPECT_THAT(line.bodies, ElementsAre("thigh", "thigh", "shank"));
  const Eigen::Vector3d last = kKnee + Eigen::Vector3d(30, -100, 0);
  EXPECT_LT((line.rest.row(2).transpose() - Turned(last, -20)).norm(),
            kTransformRounding);
  const Points target = LineTargets({line}, scene.poses[2])[0].points;
  EXPECT_LT((target.row(2).transpose() - Turned(last, -60)).norm(),
            kTransformRounding);
  // The length of the path counts the point that is active at -60.
  const Eigen::Vector3d first(20, -100, 0), between(50, -400, 0);
  EXPECT_NEAR(scene.poses[2].path_lengths.at("m"),
              (between - first).norm() + (Turned(last, -60) - between).norm(),
              kTransformRounding);
  EXPECT_NEAR(scene.poses[0].path_lengths.at("m"),
              (last - first).norm(),
              kTransformRounding);
}

TEST_F(ModelScene, OwnLinesFollowTheirBodies) {
  const Scene scene = Read();
  const Points target =
      LineTargets({scene.muscles[0].lines[1]}, scene.poses[2])[0].points;
  EXPECT_LT((target.row(0) - Eigen::RowVector3d(0, -300, 0)).norm(),
            kTransformRounding);
  EXPECT_LT(
      (target.row(1).transpose() - Turned(Eigen::Vector3d(0, -500, 0), -40))
          .norm(),
      kTransformRounding);
}

TEST_F(ModelScene, LinesFollowBodiesOfTheModelWithoutABone) {
  const Scene with_bone = Read();
  scene_["bones"].erase(1);  // the shank
  const Scene without = Read();
  for (size_t i = 0; i < without.poses.size(); ++i) {
    const auto expected =
        LineTargets(with_bone.muscles[0].lines, with_bone.poses[i]);
    const auto targets =
        LineTargets(without.muscles[0].lines, without.poses[i]);
    for (size_t k = 0; k < targets.size(); ++k) {
      EXPECT_EQ(targets[k].points, expected[k].points) << i << " " << k;
    }
  }
}

TEST_F(ModelScene, MomentArmsAreThoseOfAllLines) {
  const Scene scene = Read();
  const auto arms = PathMomentArms(
      scene, scene.poses[0], PerturbedPosesOf(*scene.model, scene.poses[0]));
  // Of a straight line from a to b about the knee at c: |(a - c) x (b - c)|
  // over the distance of a and b, positive where flexion to negative angles
  // lengthens it.
  const auto arm = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return (a - kKnee).cross(b - kKnee)[2] / (b - a).norm();
  };
  const Eigen::Vector3d first(20, -100, 0);
  EXPECT_NEAR(arms.at("m").at("knee"),
              -arm(first, kKnee + Eigen::Vector3d(30, -100, 0)),
              1e-5);
  EXPECT_NEAR(arms.at("own").at("knee"),
              -arm({0, -300, 0}, Turned({0, -500, 0}, 20)),
              1e-5);
}

TEST_F(ModelScene, TheRestPoseIsFoundWhereFramesCoincide) {
  scene_.erase("model_rest");
  // Frames that differ by the thigh's length coincide in no pose.
  ExpectRefused({"coincide", "400 mm", "model_rest"});
  const std::string at = "<translation>0 0 0</translation><orientation>0 0 0";
  model_.replace(model_.find(at),
                 at.size(),
                 "<translation>0 -0.4 0</translation><orientation>0 0 -0.5");
  const Scene scene = Read();
  ASSERT_EQ(scene.notes.size(), 1u);
  EXPECT_THAT(scene.notes[0], HasSubstr("knee -28.6479 degrees"));
  const ScenePose rest = RestPose(scene);
  // The fit ends within 1e-6 rad; the shank is 500 mm.
  EXPECT_LT((BodyTransform(rest, "shank") - Eigen::Matrix4d::Identity())
                .cwiseAbs()
                .maxCoeff(),
            1e-3);
  EXPECT_EQ(scene.muscles[0].lines[0].rest(2, 0), 30);
}

TEST_F(ModelScene, MeshesMayBeInTheFrameOfABody) {
  scene_["model_rest"]["frame"] = "shank";
  const Scene scene = Read();
  // The thigh's first point, in the frame of the shank at -20 degrees.
  const Eigen::Vector3d first(20, -100, 0);
  const Eigen::Vector3d expected =
      Eigen::AngleAxisd(RadiansOf(20), Eigen::Vector3d::UnitZ()) *
      (first - kKnee);
  EXPECT_LT(
      (scene.muscles[0].lines[0].rest.row(0).transpose() - expected).norm(),
      kTransformRounding);
}

TEST_F(ModelScene, PosesBetweenAreThoseOfTheCoordinatesBetween) {
  const Scene scene = Read();
  const ScenePose between =
      PoseBetween(scene, scene.poses[0], scene.poses[2], 0.5);
  EXPECT_LT(
      (BodyTransform(between, "shank") - BodyTransform(scene.poses[1], "shank"))
          .norm(),
      kTransformRounding);
  EXPECT_LT((between.lines.at("m") - scene.poses[1].lines.at("m")).norm(),
            kTransformRounding);
}

TEST_F(ModelScene, BonesWithoutMeshComeFromTheModel) {
  const std::string body = "<Body name=\"shank\"/>";
  model_.replace(
      model_.find(body),
      body.size(),
      "<Body name=\"shank\"><attached_geometry>"
      "<Mesh><mesh_file>tibia.ply</mesh_file><scale_factors>2 2 2"
      "</scale_factors></Mesh><Mesh><mesh_file>fibula.ply</mesh_file></Mesh>"
      "</attached_geometry></Body>");
  scene_["bones"][1].erase("mesh");
  ExpectRefused({"leg.osim", "tibia.ply", "none of the folders", dir_});
  std::filesystem::create_directories(dir_ + "/Geometry");
  WriteTextAtomically(dir_ + "/Geometry/tibia.ply", "x");
  WriteTextAtomically(dir_ + "/fibula.ply", "x");
  const Scene scene = Read();
  ASSERT_EQ(scene.bones.size(), 3u);
  EXPECT_EQ(scene.bones[1].name, "shank_tibia");
  EXPECT_EQ(scene.bones[2].name, "shank_fibula");
  EXPECT_THAT(scene.bones[1].mesh_path, HasSubstr("Geometry/tibia.ply"));
  // A point 0.1 m down the file is 200 mm down the shank, at the rest pose.
  const Points moved = Transformed(Eigen::RowVector3d(0, -0.1, 0),
                                   scene.bones[1].rest_from_file);
  EXPECT_LT((moved.row(0).transpose() -
             Turned(kKnee + Eigen::Vector3d(0, -200, 0), -20))
                .norm(),
            kTransformRounding);
  scene_["bones"][0].erase("mesh");
  ExpectRefused({"\"thigh\"", "no mesh", "attaches none"});
}

TEST_F(ModelScene, BonesMayBeThoseOfTheBodiesThatMusclesTouch) {
  for (const std::string body : {"thigh", "shank"}) {
    const std::string element = "<Body name=\"" + body + "\"/>";
    model_.replace(model_.find(element),
                   element.size(),
                   "<Body name=\"" + body + "\"><attached_geometry><Mesh>" +
                       "<mesh_file>" + body + ".ply</mesh_file></Mesh>" +
                       "</attached_geometry></Body>");
    WriteTextAtomically(dir_ + "/" + body + ".ply", "x");
  }
  scene_["bones"] = "model";
  const Scene scene = Read();
  ASSERT_EQ(scene.bones.size(), 2u);
  EXPECT_EQ(scene.bones[0].name, "thigh");
  EXPECT_EQ(scene.bones[1].name, "shank");
  EXPECT_EQ(scene.bones[1].body, "shank");
  EXPECT_THAT(scene.bones[1].mesh_path, HasSubstr("shank.ply"));
  // Bodies that no muscle is on have no bones.
  scene_["muscles"][0]["lines"] = Json::parse(
      R"([{"name": "own", "rest": [[0,-300,0],[0,-500,0]],
           "bodies": ["thigh", "thigh"]}])");
  EXPECT_EQ(Read().bones.size(), 1u);
  scene_["muscles"][0].erase("lines");
  ExpectRefused({"bones", "\"muscle\"", "does not tell", "\"lines\""});
  scene_["bones"] = "all";
  ExpectRefused({"bones", "\"all\"", "\"model\""});
}

TEST_F(ModelScene, ConditionalPointsMayBeOnBodiesThatNothingElseNames) {
  const std::string socket =
      "/bodyset/thigh</socket_parent_frame>"
      "<location>0.05";
  ASSERT_NE(model_.find(socket), std::string::npos);
  model_.replace(model_.find(socket),
                 socket.size(),
                 "/ground</socket_parent_frame><location>0.05");
  const Scene scene = Read();
  EXPECT_THAT(scene.muscles[0].lines[0].bodies,
              ElementsAre("thigh", "ground", "shank"));
  EXPECT_EQ(scene.poses[0].bodies.count("ground"), 1u);
}

TEST_F(ModelScene, PosesAtNearlyTheSameTimeHaveNamesOfTheirOwn) {
  motion_ =
      "m\ninDegrees=yes\nendheader\ntime knee\n0.49999999999 0\n0.5 -30\n"
      "0.50000000000001 -31\n";
  const Scene scene = Read();
  EXPECT_EQ(scene.poses[0].name, "t=0.5");
  EXPECT_NE(scene.poses[1].name, scene.poses[0].name);
  EXPECT_EQ(scene.poses[2].name, "t=0.50000000000001");
}

TEST_F(ModelScene, TheSceneMaySayThatAnglesAreInDegrees) {
  motion_ = "m\nendheader\ntime knee\n0 -30\n";
  ExpectRefused({"leg.mot", "\"motion_in_degrees\""});
  scene_["motion_in_degrees"] = true;
  EXPECT_NEAR(Read().poses[0].coordinates.at("knee"), -30, 1e-12);
}

TEST_F(ModelScene, AnotherMotionMayBeGiven) {
  const std::string path = dir_ + "/other.mot";
  WriteTextAtomically(path, "m\ninDegrees=no\nendheader\ntime knee\n0 0.1\n");
  EXPECT_EQ(Read("other.mot").poses.size(), 1u);
}

TEST_F(ModelScene, TheMotionMayBeInTheSceneFile) {
  const Scene of_file = Read();
  EXPECT_THAT(of_file.files, Contains(dir_ + "/leg.mot"));
  scene_["motion"] =
      Json::parse(R"({"frames": 3, "coordinates": {"knee": [0, -60]}})");
  const Scene scene = Read();
  ASSERT_EQ(scene.poses.size(), 3u);
  EXPECT_TRUE(scene.is_motion);
  EXPECT_EQ(scene.poses[1].time, 0.5);
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(scene.poses[i].bodies.at("shank"),
              of_file.poses[i].bodies.at("shank"));
  }
  EXPECT_EQ(scene.motion_path, scene.path);
  EXPECT_THAT(scene.files, Contains(scene.path).Times(1));
  EXPECT_THAT(scene.files, Not(Contains(dir_ + "/leg.mot")));
  EXPECT_EQ(Read("leg.mot").motion_path, dir_ + "/leg.mot");
  scene_["motion_in_degrees"] = false;
  ExpectRefused({"scene.json: motion", "motion_in_degrees", "leave"});
  scene_["motion_in_degrees"] = true;
  EXPECT_EQ(Read().poses.size(), 3u);
  scene_["motion"] = 3;
  ExpectRefused({"scene.json: motion: is 3", "path", "\"coordinates\""});
}

TEST_F(ModelScene, RefusesWhatDoesNotFit) {
  const Json good = scene_;
  scene_["muscles"][0]["lines"][0] = "glut_med1_r";
  ExpectRefused({"muscles[0].lines[0]", "\"glut_med1_r\"", "leg.osim"});
  scene_ = good;
  scene_["bones"][1]["body"] = "foot";
  ExpectRefused({"\"foot\"", "leg.osim", "thigh, shank"});
  scene_ = good;
  scene_["model_rest"]["coordinates"] = {{"hip", 1}};
  ExpectRefused({"model_rest.coordinates", "\"hip\""});
  scene_ = good;
  scene_["model_rest"].erase("in_degrees");
  ExpectRefused({"model_rest.in_degrees", "missing"});
  scene_ = good;
  scene_.erase("motion");
  ExpectRefused({"motion", "missing"});
  scene_ = good;
  const std::string good_motion = motion_;
  motion_ = "m\ninDegrees=yes\nendheader\ntime hip\n0 1\n";
  ExpectRefused({"leg.mot", "no column", "knee"});
  scene_ = good;
  motion_ = good_motion;
  scene_["geometry"] = "bones";
  ExpectRefused({"geometry", "no folder", dir_ + "/bones"});
}

TEST_F(ModelScene, JointsThatAreNotSupportedAreAnErrorWhereNeeded) {
  model_ = Model4(Joint4("ScrewJoint", "knee"));
  scene_["muscles"][0]["lines"].erase(0);
  ExpectRefused({"leg.osim", "\"shank\"", "ScrewJoint"});
}

}  // namespace
}  // namespace musclewarp
