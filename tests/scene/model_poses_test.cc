// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/model_poses.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "musclewarp/base/angles.h"
#include "musclewarp/scene/line_targets.h"
#include "scene/transform_checks.h"
#include "support/input_errors.h"
#include "support/osim_models.h"

namespace musclewarp {
namespace {

using Eigen::Matrix4d;
using ::testing::ElementsAre;

Model LegModel() {
  return ReadModel(
      Written("leg.osim",
              Model4(Joint4("PinJoint", "knee"),
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
                                Point4("p3", "shank", "0.03 -0.1 0")))));
}

// The leg with meshes made at a knee angle (rad), in the frame of a body.
ModelPoses Bound(double knee, const std::string& frame = "") {
  ModelRest rest;
  rest.coordinates = {{"knee", knee}};
  rest.frame = frame;
  std::vector<std::string> notes;
  ModelPoses poses =
      BindModel(LegModel(), rest, {"thigh", "shank"}, "scene.json", &notes);
  poses.muscles = {0};
  poses.given_coordinates = {0};
  return poses;
}

TEST(BindModel, TheRestPoseMovesNothing) {
  for (const char* frame : {"", "thigh", "shank"}) {
    const ModelPoses poses = Bound(-0.4, frame);
    const ScenePose rest = PoseAt(poses, poses.rest);
    for (const char* body : {"thigh", "shank"}) {
      EXPECT_LT(Difference(rest.bodies.at(body), Matrix4d::Identity()),
                kTransformRounding)
          << frame << " " << body;
    }
    const ActionLine line = LineOfMuscle(poses, 0);
    EXPECT_LT((rest.lines.at("m") - line.rest).norm(), kTransformRounding)
        << frame;
  }
}

TEST(BindModel, MeshesMayBeInTheFrameOfABody) {
  const ModelPoses poses = Bound(-0.4, "shank");
  // The last point of the path as the model has it on the shank.
  EXPECT_LT(
      (LineOfMuscle(poses, 0).rest.row(2) - Eigen::RowVector3d(30, -100, 0))
          .norm(),
      kTransformRounding);
  // The thigh is fixed to the ground, whatever the frame.
  EXPECT_LT(
      Difference(PoseAt(poses, {0.7}).bodies.at("thigh"), Matrix4d::Identity()),
      kTransformRounding);
}

TEST(BindModel, RefusesNamesThatTheModelLacks) {
  std::vector<std::string> notes;
  ModelRest rest;
  rest.coordinates.emplace();
  ExpectInputError(
      [&] { BindModel(LegModel(), rest, {"foot"}, "scene.json", &notes); },
      {"scene.json", "\"foot\"", "leg.osim", "thigh, shank"});
  rest.coordinates = {{"hip", 0.0}};
  ExpectInputError(
      [&] { BindModel(LegModel(), rest, {"thigh"}, "scene.json", &notes); },
      {"scene.json: model_rest.coordinates", "\"hip\""});
}

TEST(LineOfMuscle, HasThePointsThatComeAndGoInEveryPose) {
  for (const double knee : {-1.0, 0.2}) {
    const ActionLine line = LineOfMuscle(Bound(knee), 0);
    EXPECT_EQ(line.name, "m");
    EXPECT_THAT(line.bodies, ElementsAre("thigh", "thigh", "shank"));
    EXPECT_EQ(line.rest.rows(), 3);
  }
}

TEST(PoseAt, PointsOfAPathMoveWithTheirBodies) {
  const ModelPoses poses = Bound(-0.4);
  const ScenePose pose = PoseAt(poses, {0.7});
  ScenePose bodies_only = pose;
  bodies_only.lines.clear();
  const Points moved =
      LineTargets({LineOfMuscle(poses, 0)}, bodies_only)[0].points;
  // The point between is conditional, and near the end of its range at rest.
  for (const int point : {0, 2}) {
    EXPECT_LT((pose.lines.at("m").row(point) - moved.row(point)).norm(),
              kTransformRounding);
  }
}

TEST(PoseAt, GivesAnglesInDegreesAndValuesInRadians) {
  const ScenePose pose = PoseAt(Bound(0), {0.5});
  EXPECT_NEAR(pose.coordinates.at("knee"), DegreesOf(0.5), 1e-12);
  EXPECT_THAT(pose.model_values, ElementsAre(0.5));
}

}  // namespace
}  // namespace musclewarp
