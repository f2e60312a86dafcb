// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/line_targets.h"

#include <gtest/gtest.h>

namespace musclewarp {
namespace {

ActionLine Line() {
  ActionLine line;
  line.name = "line";
  line.rest.resize(3, 3);
  line.rest << 0, 0, 0, 10, 0, 0, 20, 0, 0;
  line.bodies = {"pelvis", "pelvis", "femur"};
  return line;
}

ScenePose Pose() {
  ScenePose pose;
  pose.bodies["femur"] = Eigen::Matrix4d::Identity();
  // A quarter turn about z and a shift along z.
  pose.bodies["femur"].topLeftCorner<2, 2>() << 0, -1, 1, 0;
  pose.bodies["femur"](2, 3) = 5;
  return pose;
}

}  // namespace

TEST(LineTargets, PointsMoveWithTheirBodies) {
  const LineTarget target = LineTargets({Line()}, Pose())[0];
  Points expected(3, 3);
  expected << 0, 0, 0, 10, 0, 0, 0, 20, 5;
  EXPECT_EQ(target.points, expected);
  ASSERT_EQ(target.body_rotations.size(), 3u);
  EXPECT_TRUE(target.body_rotations[0]->isIdentity(0));
  EXPECT_EQ((*target.body_rotations[2])(1, 0), 1);
}

TEST(LineTargets, GivenTargetsComeFirst) {
  ScenePose pose = Pose();
  pose.lines["line"] = 2 * Line().rest;
  const LineTarget target = LineTargets({Line()}, pose)[0];
  EXPECT_EQ(target.points, 2 * Line().rest);
  EXPECT_EQ(target.body_rotations.size(), 3u);
}

TEST(LineTargets, WithoutBodiesLinesStay) {
  ActionLine line = Line();
  line.bodies.clear();
  const LineTarget target = LineTargets({line}, Pose())[0];
  EXPECT_EQ(target.points, line.rest);
  EXPECT_TRUE(target.body_rotations.empty());
}

}  // namespace musclewarp
