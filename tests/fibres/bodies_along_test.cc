// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/fibres/bodies_along.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fibres/ball_bones.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;

// Points on the x axis, 10 mm apart.
Points LineOf(int count) {
  Points line = Points::Zero(count, 3);
  for (int i = 0; i < count; ++i) line(i, 0) = 10 * i;
  return line;
}

TEST(BodiesAlong, ChangeHalfwayBetweenTwoBones) {
  BallBones bones;
  bones.Add("pelvis", {0, 20, 0});
  bones.Add("femur", {50, 20, 0});
  EXPECT_THAT(
      BodiesAlong(LineOf(6), "pelvis", "femur", bones.bodies()),
      ElementsAre("pelvis", "pelvis", "pelvis", "femur", "femur", "femur"));
  EXPECT_THAT(BodiesAlong(LineOf(6), "femur", "pelvis", bones.bodies())[0],
              "femur");
}

TEST(BodiesAlong, FollowTheBoneBetweenWhereItIsNearest) {
  BallBones bones;
  bones.Add("pelvis", {0, 20, 0});
  bones.Add("patella", {40, 20, 0});
  bones.Add("femur", {60, 20, 0});
  // At 20 mm both are equally far; at 50 mm, too.
  const auto bodies = BodiesAlong(LineOf(7), "pelvis", "femur", bones.bodies());
  EXPECT_EQ(bodies[1], "pelvis");
  EXPECT_EQ(bodies[3], "patella");
  EXPECT_EQ(bodies[4], "patella");
  EXPECT_EQ(bodies[6], "femur");
}

// Both ends are fixed to their bodies, however near another one is, and of two
// between only one is followed: the one that saves more.
TEST(BodiesAlong, BeginAndEndWhereTheMuscleDoes) {
  BallBones bones;
  bones.Add("pelvis", {0, 300, 0});
  bones.Add("patella", {20, 30, 0});
  bones.Add("femur", {40, 300, 0});
  bones.Add("tibia", {20, 20, 0});
  EXPECT_THAT(BodiesAlong(LineOf(5), "pelvis", "femur", bones.bodies()),
              ElementsAre("pelvis", "tibia", "tibia", "tibia", "femur"));
  EXPECT_THAT(BodiesAlong(LineOf(2), "pelvis", "femur", bones.bodies()),
              ElementsAre("pelvis", "femur"));
}

// One contiguous part each: back at its origin a line does not follow that
// again.
TEST(BodiesAlong, FollowEachBodyOnce) {
  BallBones bones;
  bones.Add("pelvis", {0, 20, 0});
  bones.Add("pelvis", {60, 20, 0});
  bones.Add("femur", {30, 20, 0});
  const auto bodies = BodiesAlong(LineOf(8), "pelvis", "femur", bones.bodies());
  int changes = 0;
  for (size_t i = 1; i < bodies.size(); ++i) {
    changes += bodies[i] != bodies[i - 1];
  }
  EXPECT_LE(changes, 2);
  EXPECT_EQ(bodies.front(), "pelvis");
  EXPECT_EQ(bodies.back(), "femur");
}

}  // namespace
}  // namespace musclewarp
