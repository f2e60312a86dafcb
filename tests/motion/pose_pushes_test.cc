// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/pose_pushes.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <string>

#include "musclewarp/motion/way_from_rest.h"
#include "musclewarp/preparation/bone_pushes.h"
#include "musclewarp/scene/line_targets.h"
#include "musclewarp/scene/moved_pose.h"
#include "musclewarp/scene/scene.h"
#include "support/meshes.h"
#include "support/prepared_small_scene.h"

namespace musclewarp {
namespace {

// The small scene with a ball 5 mm beside its muscles.
PreparedScene SceneWithABall() {
  Scene scene = SmallScene();
  const TriangleSoup ball = SphereAt({0, 35, 0}, 20, 3);
  scene.bones.push_back({"ball", ball.points, ball.triangles});
  PreparedScene prepared = PreparedSmallScene(scene);
  AddBonePushes({}, &prepared);
  return prepared;
}

// The femur turned, and the ball 5 mm in the muscles.
ScenePose PressedPose(double angle = 0.3) {
  ScenePose pose = FlexedPose(angle);
  pose.bodies["ball"] = Eigen::Matrix4d::Identity();
  pose.bodies["ball"](1, 3) = -10;
  return pose;
}

Eigen::Matrix4d SomeMotion() {
  Eigen::Matrix4d motion = Eigen::Matrix4d::Identity();
  motion.topLeftCorner<3, 3>() =
      Eigen::AngleAxisd(1.1, Eigen::Vector3d(2, -1, 1).normalized())
          .toRotationMatrix();
  motion.topRightCorner<3, 1>() << 300, -120, 40;
  return motion;
}

class WithPushesTest : public testing::Test {
 protected:
  ScenePose Pushed(const ScenePose& pose) const {
    return WithPushes(scene_, {}, pose);
  }

  const PreparedScene scene_ = SceneWithABall();
};

TEST_F(WithPushesTest, NothingIsPushedAtRest) {
  EXPECT_TRUE(Pushed(RestPose(scene_.scene)).pushes.empty());
}

TEST_F(WithPushesTest, TheFreeShapeMovesByThePush) {
  const ScenePose pose = PressedPose();
  const ScenePose pushed = Pushed(pose);
  for (const PreparedMuscle& muscle : scene_.muscles) {
    const MuscleModel& model = muscle.model;
    const Points& push = pushed.pushes.at(model.name);
    EXPECT_GT(push.rowwise().norm().maxCoeff(), 3);
    const Points moved =
        UnconstrainedMinimizer(model, TargetOf(model, pushed, {})) -
        UnconstrainedMinimizer(model, TargetOf(model, pose, {}));
    EXPECT_LT((moved - push).cwiseAbs().maxCoeff(), 1e-9);
  }
}

// Law: what moves everything moves the pushes along.
TEST_F(WithPushesTest, WhatMovesEverythingHasNoPart) {
  const ScenePose pose = PressedPose();
  ScenePose named = pose;  // a body that is not named does not move
  for (const std::string& body : BodiesInUse(scene_.scene)) {
    named.bodies.emplace(body, Eigen::Matrix4d::Identity());
  }
  const ScenePose moved = Pushed(MovedPose(named, SomeMotion()));
  const ScenePose expected = MovedPose(Pushed(named), SomeMotion());
  ASSERT_EQ(expected.pushes.size(), 2u);
  ASSERT_EQ(moved.pushes.size(), expected.pushes.size());
  for (const auto& [muscle, push] : expected.pushes) {
    EXPECT_LT((moved.pushes.at(muscle) - push).cwiseAbs().maxCoeff(), 1e-5);
  }
}

// Law: it is a function of the pose, whatever pose it is taken after.
TEST_F(WithPushesTest, APoseHasThePushesOfItsOwn) {
  const ScenePose pose = PressedPose();
  ScenePose after = Pushed(PressedPose(-0.3));
  after.bodies = pose.bodies;
  EXPECT_EQ(Pushed(after).pushes, Pushed(pose).pushes);
}

TEST(WayFromRest, GoesFromRestToThePose) {
  const PreparedScene scene = PreparedSmallScene();
  const ScenePose pose = FlexedPose(1);
  const auto way = WayFromRest(scene.scene, pose);
  ASSERT_EQ(way.size(), 4u);  // a step for each 20 degrees
  EXPECT_EQ(way.back().bodies, pose.bodies);
  for (const auto& [body, motion] : way.front().bodies) {
    EXPECT_LT((motion - Eigen::Matrix4d::Identity()).norm(), 1e-12) << body;
  }
}

// Law: seen from the first body, the way is that of the other bodies alone.
TEST(WayFromRest, LeavesTheFirstBodyWhereItIs) {
  const PreparedScene scene = PreparedSmallScene();
  const std::string first = BodiesInUse(scene.scene)[0];
  ScenePose pose = FlexedPose(1);
  pose.bodies[first] = SomeMotion();
  for (const ScenePose& part : WayFromRest(scene.scene, pose)) {
    EXPECT_LT((BodyTransform(part, first) - SomeMotion()).norm(), 1e-9);
  }
}

}  // namespace
}  // namespace musclewarp
