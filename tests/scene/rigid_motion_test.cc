// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/rigid_motion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace musclewarp {
namespace {

using ::testing::HasSubstr;

Eigen::Matrix4d RigidTurn(double angle) {
  Eigen::Matrix4d turn = Eigen::Matrix4d::Identity();
  turn(0, 0) = turn(1, 1) = std::cos(angle);
  turn(1, 0) = std::sin(angle);
  turn(0, 1) = -turn(1, 0);
  turn(2, 3) = 100;
  return turn;
}

TEST(RigidMotionFault, IsEmptyForATurnAndAMove) {
  EXPECT_EQ(RigidMotionFault(RigidTurn(0)), "");
  EXPECT_EQ(RigidMotionFault(RigidTurn(1)), "");
}

TEST(RigidMotionFault, AllowsFourDigits) {
  Eigen::Matrix4d turn = RigidTurn(1);
  turn.topLeftCorner<2, 2>() =
      (turn.topLeftCorner<2, 2>() * 1e4).array().round() / 1e4;
  EXPECT_EQ(RigidMotionFault(turn), "");
}

TEST(RigidMotionFault, NamesScalesMirrorsAndTransposedMatrices) {
  Eigen::Matrix4d scale = RigidTurn(0);
  scale(0, 0) = 1.01;
  EXPECT_THAT(RigidMotionFault(scale), HasSubstr("not a rotation"));
  Eigen::Matrix4d mirror = RigidTurn(0);
  mirror(0, 0) = -1;
  EXPECT_THAT(RigidMotionFault(mirror), HasSubstr("not a rotation"));
  EXPECT_THAT(RigidMotionFault(RigidTurn(1).transpose()),
              HasSubstr("last row"));
  Eigen::Matrix4d unknown = RigidTurn(0);
  unknown(0, 3) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(RigidMotionFault(unknown), "");
}

}  // namespace
}  // namespace musclewarp
