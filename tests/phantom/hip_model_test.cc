// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/phantom/hip_model.h"

#include <gtest/gtest.h>

#include "musclewarp/base/output_file.h"
#include "musclewarp/opensim/kinematics.h"
#include "musclewarp/opensim/model.h"
#include "musclewarp/opensim/storage_table.h"
#include "musclewarp/phantom/scene_parts.h"
#include "support/temp_dir.h"

namespace musclewarp::phantom {
namespace {

// The model has twelve digits, of numbers of up to 200 mm.
constexpr double kDigitRounding = 1e-9;

const Eigen::Vector3d kCentre(90, -5, 40);
const Eigen::Vector3d kFlexedPoint(70, 30, 20);

// A muscle with one line: two points on the pelvis, of which the second wraps,
// and one on the femur.
Scene PsoasScene() {
  ActionLine line;
  line.name = "psoas";
  line.bodies = {"pelvis", "pelvis", "femur_r"};
  line.rest.resize(3, 3);
  line.rest << 20, 0, 150, 80, 20, 45, 95, -10, -30;
  SceneMuscle muscle;
  muscle.name = "psoas_major";
  muscle.lines = {line};
  Scene scene;
  scene.muscles = {muscle};
  return scene;
}

Model SmallModel() {
  const std::string path = TestTempDir() + "/hip.osim";
  WriteTextAtomically(
      path, HipModelText(PsoasScene(), kCentre, {"psoas", 1, kFlexedPoint}));
  return ReadModel(path);
}

TEST(HipModel, AtRestTheLinesAreThoseOfTheScene) {
  const Model model = SmallModel();
  EXPECT_TRUE(model.warnings.empty());
  ASSERT_EQ(model.muscles.size(), 1u);
  const ModelMuscle& psoas = model.muscles[0];
  EXPECT_EQ(psoas.name, "psoas");
  ASSERT_EQ(psoas.path.size(), 3u);
  const CoordinateValues rest = DefaultValues(model);
  const auto frames = BodyFrames(model, rest);
  const ActionLine line = PsoasScene().muscles[0].lines[0];
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(model.bodies[psoas.path[i].body].name, line.bodies[i]);
    EXPECT_LT(
        (LocationOnBody(psoas.path[i], rest) - line.rest.row(i).transpose())
            .norm(),
        kDigitRounding);
    EXPECT_LT((frames[psoas.path[i].body] - Eigen::Matrix4d::Identity()).norm(),
              kDigitRounding);
  }
}

TEST(HipModel, FlexionTurnsTheFemurAboutTheHipCentre) {
  const Model model = SmallModel();
  CoordinateValues values = DefaultValues(model);
  values[model.FindCoordinate("hip_flexion_r")] = M_PI / 3;
  const auto frames = BodyFrames(model, values);
  EXPECT_LT((frames[model.FindBody("femur_r")] -
             RotationAbout(kCentre, Eigen::Vector3d::UnitX(), 60))
                .norm(),
            kDigitRounding);
  EXPECT_LT(
      (frames[model.FindBody("pelvis")] - Eigen::Matrix4d::Identity()).norm(),
      kDigitRounding);
}

TEST(HipModel, TheWrappedPointMovesStraight) {
  const Model model = SmallModel();
  CoordinateValues values = DefaultValues(model);
  const PathPoint& point = model.muscles[0].path[1];
  const Eigen::Vector3d rest(80, 20, 45);
  for (const double share : {0.0, 0.5, 1.0}) {
    values[model.FindCoordinate("hip_flexion_r")] = share * M_PI / 3;
    EXPECT_LT(
        (LocationOnBody(point, values) - (rest + share * (kFlexedPoint - rest)))
            .norm(),
        kDigitRounding)
        << share;
  }
}

TEST(HipModel, TheMotionFlexesFromMinus10To60Degrees) {
  const std::string path = TestTempDir() + "/hip.mot";
  WriteTextAtomically(path, HipMotionText());
  const StorageTable motion = ReadStorageTable(path);
  EXPECT_TRUE(motion.warnings.empty());
  EXPECT_EQ(motion.in_degrees, true);
  EXPECT_EQ(motion.labels, std::vector<std::string>{"hip_flexion_r"});
  ASSERT_EQ(motion.times.size(), 15u);
  EXPECT_EQ(motion.times.front(), 0);
  EXPECT_EQ(motion.times.back(), 0.7);
  for (int i = 0; i < 15; ++i) EXPECT_EQ(motion.values(i, 0), -10 + 5 * i);
}

}  // namespace
}  // namespace musclewarp::phantom
