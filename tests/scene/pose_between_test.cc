// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "musclewarp/scene/line_targets.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {
namespace {

constexpr double kRounding = 1e-13;

Eigen::Matrix4d Turn(double angle) {
  Eigen::Matrix4d turn = Eigen::Matrix4d::Identity();
  turn.topLeftCorner<3, 3>() =
      Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitX()).toRotationMatrix();
  return turn;
}

Scene OneLine() {
  Scene scene;
  scene.muscles.resize(1);
  scene.muscles[0].lines.resize(2);
  scene.muscles[0].lines[0].name = "given";
  scene.muscles[0].lines[0].rest.resize(2, 3);
  scene.muscles[0].lines[0].rest << 0, 0, 0, 0, 0, 9;
  scene.muscles[0].lines[1] = scene.muscles[0].lines[0];
  scene.muscles[0].lines[1].name = "carried";
  scene.muscles[0].lines[1].bodies = {"a", "b"};
  return scene;
}

TEST(PoseBetween, TurnsBodiesEvenlyAndMovesGivenLinesStraight) {
  const Scene scene = OneLine();
  ScenePose from, to;
  to.bodies["b"] = Turn(1.2);
  to.bodies["b"](0, 3) = 8;
  to.lines["given"] = scene.muscles[0].lines[0].rest.array() + 4;
  const ScenePose between = PoseBetween(scene, from, to, 0.25);
  Eigen::Matrix4d expected = Turn(0.3);
  expected(0, 3) = 2;
  EXPECT_LT((between.bodies.at("b") - expected).norm(), kRounding);
  EXPECT_LT((between.lines.at("given").array() -
             (scene.muscles[0].lines[0].rest.array() + 1))
                .matrix()
                .norm(),
            kRounding);
  EXPECT_EQ(between.lines.count("carried"), 0u);
}

TEST(PoseBetween, EndsAreThePoses) {
  const Scene scene = OneLine();
  ScenePose from, to;
  from.bodies["a"] = Turn(-0.4);
  to.bodies["b"] = Turn(1.2);
  for (const double part : {0.0, 1.0}) {
    const ScenePose& end = part == 0 ? from : to;
    const ScenePose between = PoseBetween(scene, from, to, part);
    for (const char* body : {"a", "b"}) {
      EXPECT_LT(
          (BodyTransform(between, body) - BodyTransform(end, body)).norm(),
          kRounding);
    }
  }
}

}  // namespace
}  // namespace musclewarp
