// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "musclewarp/scene/line_targets.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {
namespace {

constexpr double kPoseRounding = 1e-13;

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
  EXPECT_LT((between.bodies.at("b") - expected).norm(), kPoseRounding);
  EXPECT_LT((between.lines.at("given").array() -
             (scene.muscles[0].lines[0].rest.array() + 1))
                .matrix()
                .norm(),
            kPoseRounding);
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
          kPoseRounding);
    }
  }
}

// About an axis through `centre`.
Eigen::Matrix4d TurnAbout(const Eigen::Vector3d& centre, double angle) {
  Eigen::Matrix4d turn = Turn(angle);
  turn.topRightCorner<3, 1>() = centre - turn.topLeftCorner<3, 3>() * centre;
  return turn;
}

TEST(PoseBetween, JointsFarFromTheOriginStayWhereTheyAre) {
  const Scene scene = OneLine();
  const Eigen::Vector3d joint(-80, -90, 820);
  ScenePose from, to;
  from.bodies["b"] = TurnAbout(joint, 0.3);
  to.bodies["b"] = TurnAbout(joint, 1.1);
  for (const double part : {0.2, 0.5, 0.9}) {
    const Eigen::Matrix4d between =
        PoseBetween(scene, from, to, part).bodies.at("b");
    // Rounding of places 800 mm from the origin.
    EXPECT_LT((between - TurnAbout(joint, 0.3 + 0.8 * part)).norm(), 1e-11);
  }
}

TEST(PoseBetween, PointsWithAShareOfATurnGoAlongIt) {
  Scene scene = OneLine();
  const Eigen::Vector3d joint(-80, -90, 820);
  const Points rest = scene.muscles[0].lines[0].rest;
  ScenePose from, to;
  to.bodies["b"] = TurnAbout(joint, 0.8);
  const auto moved = [&](double share) {
    Points points(2, 3);  // the first with half of the turn
    for (int k = 0; k < 2; ++k) {
      const Eigen::Matrix4d turn =
          TurnAbout(joint, (k == 0 ? 0.5 : 1.0) * share * 0.8);
      points.row(k) = (turn.topLeftCorner<3, 3>() * rest.row(k).transpose() +
                       turn.topRightCorner<3, 1>())
                          .transpose();
    }
    return points;
  };
  to.lines["given"] = moved(1);
  const ScenePose between = PoseBetween(scene, from, to, 0.4);
  // The share is found to the root of rounding.
  EXPECT_LT((between.lines.at("given") - moved(0.4)).norm(), 1e-4);
}

TEST(PoseBetween, MovesWithoutATurnAreStraight) {
  const Scene scene = OneLine();
  ScenePose from, to;
  to.bodies["b"] = Eigen::Matrix4d::Identity();
  to.bodies["b"].topRightCorner<3, 1>() << 1, 2, 3;
  const Eigen::Matrix4d between =
      PoseBetween(scene, from, to, 0.5).bodies.at("b");
  EXPECT_EQ((between.topRightCorner<3, 1>()), Eigen::Vector3d(0.5, 1, 1.5));
}

}  // namespace
}  // namespace musclewarp
