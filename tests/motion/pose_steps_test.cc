// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/pose_steps.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <string>

namespace musclewarp {
namespace {

Scene OneBoneOneLine() {
  Scene scene;
  scene.bones.resize(1);
  scene.bones[0].body = "femur";
  scene.muscles.resize(1);
  ActionLine line;
  line.name = "line";
  line.rest.resize(2, 3);
  line.rest << 0, 0, 0, 0, 0, 100;
  line.bodies = {"pelvis", "femur"};
  scene.muscles[0].lines = {line};
  return scene;
}

ScenePose Turned(double angle) {
  ScenePose pose;
  Eigen::Matrix4d turn = Eigen::Matrix4d::Identity();
  turn.topLeftCorner<3, 3>() =
      Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitX()).toRotationMatrix();
  pose.bodies["femur"] = turn;
  return pose;
}

TEST(StepsBetween, CountsTurnsOfBonesAndMovesOfLines) {
  const Scene scene = OneBoneOneLine();
  StepLimits options;
  options.max_turn = 0.1;
  options.max_move = 1e6;
  EXPECT_EQ(StepsBetween(scene, Turned(0), Turned(0), options), 1);
  EXPECT_EQ(StepsBetween(scene, Turned(0), Turned(0.09), options), 1);
  EXPECT_EQ(StepsBetween(scene, Turned(0.5), Turned(-0.15), options), 7);
  options.max_turn = 1e6;
  options.max_move = 10;
  // The end of the line moves 2 * 100 * sin(0.25) = 49.5 mm.
  EXPECT_EQ(StepsBetween(scene, Turned(0), Turned(0.5), options), 5);
}

TEST(StepLimits, NameWhatIsWrong) {
  StepLimits limits;
  std::string error;
  EXPECT_TRUE(limits.IsValid(&error));
  limits.max_turn = 0;
  EXPECT_FALSE(limits.IsValid(&error));
  EXPECT_EQ(error, "StepLimits::max_turn is 0, allowed: above 0");
}

}  // namespace
}  // namespace musclewarp
