// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/line_targets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "musclewarp/mesh/transformed.h"
#include "musclewarp/skeleton/polyline.h"

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

// Along x, over a joint at the origin.
ActionLine SlidingLine() {
  ActionLine line;
  line.name = "sliding";
  line.rest = Points::Zero(9, 3);
  line.rest.col(0).setLinSpaced(-40, 40);
  line.rest.col(1).setConstant(10);
  line.bodies.assign(9, "pelvis");
  std::fill(line.bodies.begin() + 4, line.bodies.end(), "femur");
  line.slides = true;
  return line;
}

// The femur turned about z.
ScenePose Turned(double angle) {
  ScenePose pose;
  Eigen::Matrix4d& femur = pose.bodies["femur"];
  femur.setIdentity();
  femur.topLeftCorner<2, 2>() << std::cos(angle), -std::sin(angle),
      std::sin(angle), std::cos(angle);
  return pose;
}

constexpr double kRounding = 1e-12;  // of coordinates of tens of mm

ScenePose Pose() {
  ScenePose pose;
  pose.bodies["femur"] = Eigen::Matrix4d::Identity();
  // A quarter turn about z and a shift along z.
  pose.bodies["femur"].topLeftCorner<2, 2>() << 0, -1, 1, 0;
  pose.bodies["femur"](2, 3) = 5;
  return pose;
}

}  // namespace

TEST(LineTargets, ASlidingLineIsStretchedEvenlyBetweenItsEnds) {
  const ActionLine line = SlidingLine();
  for (const double angle : {-1.5, 0.0, 0.4, 1.5}) {
    const ScenePose pose = Turned(angle);
    const Points points = LineTargets({line}, pose)[0].points;
    EXPECT_EQ(points.row(0), line.rest.row(0));
    EXPECT_LT(
        (points.row(8) - Transformed(line.rest.row(8), pose.bodies.at("femur")))
            .norm(),
        kRounding);
    // Corners are cut by the segments across them.
    const double mean = PolylineLength(points) / 8;
    for (int i = 0; i < 8; ++i) {
      EXPECT_NEAR(
          (points.row(i + 1) - points.row(i)).norm(), mean, 0.15 * mean);
    }
  }
}

TEST(LineTargets, ASlidingLineDoesNotFoldBackWhereAJointCloses) {
  ActionLine line = SlidingLine();
  for (const bool slides : {true, false}) {
    line.slides = slides;
    const Points points = LineTargets({line}, Turned(1.5))[0].points;
    double least = 1;  // cosine of the angle between neighbouring segments
    for (int i = 1; i < 8; ++i) {
      const Eigen::RowVector3d before = points.row(i) - points.row(i - 1);
      const Eigen::RowVector3d after = points.row(i + 1) - points.row(i);
      least = std::min(least, before.normalized().dot(after.normalized()));
    }
    if (slides) {
      EXPECT_GT(least, 0);
    } else {
      EXPECT_LT(least, 0);  // it does where points have one body each
    }
  }
}

TEST(LineTargets, ASlidingLineMovesRigidlyWithAllBodies) {
  const ActionLine line = SlidingLine();
  ScenePose pose = Turned(2);
  pose.bodies["femur"](0, 3) = 7;
  pose.bodies["pelvis"] = pose.bodies["femur"];
  EXPECT_LT((LineTargets({line}, pose)[0].points -
             Transformed(line.rest, pose.bodies["femur"]))
                .cwiseAbs()
                .maxCoeff(),
            kRounding);
}

// The sliding line with bends that yield and some that do not.
ActionLine TautLine() {
  ActionLine line = SlidingLine();
  line.name = "taut";
  line.rest(3, 1) += 2;
  line.rest(5, 1) += 2;
  LineSupports supports;
  supports.bends = supports.outward = Points::Zero(9, 3);
  supports.loads = supports.stiffness = supports.plane_stiffness =
      supports.hold = Eigen::VectorXd::Zero(9);
  for (int i = 2; i <= 6; ++i) {
    const Eigen::RowVector3d bend =
        (line.rest.row(i + 1) - line.rest.row(i)).normalized() -
        (line.rest.row(i) - line.rest.row(i - 1)).normalized();
    supports.loads[i] = bend.norm();
    supports.bends.row(i) = bend.normalized();
    supports.stiffness[i] = i < 5 ? bend.norm() / 5 : 10;
  }
  line.supports = supports;
  return line;
}

TEST(LineTargets, ATautLineIsAtRestWithItsBodies) {
  EXPECT_EQ(LineTargets({TautLine()}, Turned(0))[0].points, TautLine().rest);
}

TEST(LineTargets, ATautLineHasTheRotationsOfItsBodies) {
  const LineTarget target = LineTargets({TautLine()}, Turned(0.4))[0];
  ASSERT_EQ(target.body_rotations.size(), 9u);
  EXPECT_TRUE(target.body_rotations[0]->isIdentity(0));
  EXPECT_NEAR((*target.body_rotations[8])(1, 0), std::sin(0.4), kRounding);
}

TEST(WithTautLines, GivesWhatLineTargetsWouldSolve) {
  Scene scene;
  SceneMuscle& muscle = scene.muscles.emplace_back();
  muscle.lines = {TautLine()};
  const ScenePose pose = WithTautLines(scene, Turned(0.4));
  EXPECT_EQ(pose.taut_lines.points.at("taut"),
            LineTargets(muscle.lines, Turned(0.4))[0].points);
  EXPECT_EQ(LineTargets(muscle.lines, pose)[0].points,
            pose.taut_lines.points.at("taut"));
  // Not for other positions of the bodies.
  ScenePose moved = pose;
  moved.bodies = Turned(0.5).bodies;
  EXPECT_EQ(LineTargets(muscle.lines, moved)[0].points,
            LineTargets(muscle.lines, Turned(0.5))[0].points);
}

TEST(SetTautLines, MovesThemOnByTheirDerivative) {
  constexpr double kAngle = 0.3;
  const auto at = [](double angle) {
    return LineTargets({TautLine()}, Turned(angle))[0].points;
  };
  std::vector<PerturbedPoses> beside(1);
  beside[0].before = Turned(kAngle - PerturbedPoses::kStep);
  beside[0].after = Turned(kAngle + PerturbedPoses::kStep);
  SetTautLines({TautLine()}, Turned(kAngle), &beside);
  // Second derivatives of some 100 mm, of a step of 1e-4: 1e-6 mm.
  EXPECT_LT(
      (beside[0].after.lines.at("taut") - at(kAngle + PerturbedPoses::kStep))
          .cwiseAbs()
          .maxCoeff(),
      1e-5);
  EXPECT_LT(
      (beside[0].before.lines.at("taut") - at(kAngle - PerturbedPoses::kStep))
          .cwiseAbs()
          .maxCoeff(),
      1e-5);
}

TEST(SetTautLines, MovesThemExactlyWithBodiesThatMoveAsOne) {
  const auto both = [](double angle) {
    ScenePose pose = Turned(angle);
    pose.bodies["pelvis"] = pose.bodies["femur"];
    return pose;
  };
  std::vector<PerturbedPoses> beside(1);
  beside[0].before = both(0.3 - PerturbedPoses::kStep);
  beside[0].after = both(0.3 + PerturbedPoses::kStep);
  SetTautLines({TautLine()}, both(0.3), &beside);
  EXPECT_LT((beside[0].after.lines.at("taut") -
             Transformed(TautLine().rest, beside[0].after.bodies["femur"]))
                .cwiseAbs()
                .maxCoeff(),
            1e-11);
}

TEST(SetTautLines, LeavesLinesToWhichThePoseGivesPoints) {
  ScenePose pose = Turned(0.3);
  pose.lines["taut"] = TautLine().rest;
  std::vector<PerturbedPoses> beside(1);
  beside[0].before = beside[0].after = pose;
  SetTautLines({TautLine()}, pose, &beside);
  EXPECT_EQ(beside[0].after.lines.at("taut"), TautLine().rest);
}

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
