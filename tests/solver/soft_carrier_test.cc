// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/soft_carrier.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "musclewarp/solver/muscle_model.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

using Eigen::Matrix4d;

// A line along z from 0 to 200 mm, from the femur to the foot.
ActionLine LineAlongZ() {
  ActionLine line;
  line.name = "tendon_1";
  line.rest.resize(5, 3);
  line.rest << 0, 0, 200, 0, 0, 150, 0, 0, 100, 0, 0, 50, 0, 0, 0;
  line.bodies = {"femur", "femur", "femur", "foot", "foot"};
  line.slides = true;
  return line;
}

// An area beside the line at z = 40.
Points Area() {
  Points area(4, 3);
  area << 5, 0, 36, 5, 0, 44, 4, 3, 40, 4, -3, 40;
  return area;
}

// A tendon along the line.
MuscleModel Tendon() {
  const TriangleSoup hull = MovedBy(Spindle(8, 105, 2), {0, 0, 100});
  MuscleModel model;
  model.name = "tendon";
  model.lines = {LineAlongZ()};
  model.guides = GuidesOf(model.lines, LineRule::kSlide, {});
  model.coarse_rest = hull.points;
  model.coarse_triangles = hull.triangles;
  return model;
}

SoftCarrier Carrier() { return CarrierOf(Area(), Tendon()); }

Matrix4d Motion(const Eigen::AngleAxisd& turn, const Eigen::Vector3d& by) {
  Matrix4d motion = Matrix4d::Identity();
  motion.topLeftCorner<3, 3>() = turn.toRotationMatrix();
  motion.topRightCorner<3, 1>() = by;
  return motion;
}

TEST(SoftCarrier, StaysAtRest) {
  EXPECT_LT(
      (TransformOf(Carrier(), {}) - Matrix4d::Identity()).cwiseAbs().maxCoeff(),
      1e-12);
}

TEST(SoftCarrier, HasTheMotionThatAllBodiesShare) {
  const Matrix4d motion =
      Motion(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1).normalized()),
             {3, 9, -4});
  ScenePose pose;
  pose.bodies = {{"femur", motion}, {"foot", motion}};
  EXPECT_LT((TransformOf(Carrier(), pose) - motion).cwiseAbs().maxCoeff(),
            1e-10);
}

TEST(SoftCarrier, MovesAsItsPlaceOnTheLine) {
  ScenePose pose;
  pose.bodies["foot"] =
      Motion(Eigen::AngleAxisd::Identity(), Eigen::Vector3d(0, 0, -20));
  // At 40 of 200 mm from the foot the line moves by 4/5 of 20 mm.
  const Matrix4d moved = TransformOf(Carrier(), pose);
  EXPECT_NEAR(moved(2, 3), -16, 0.5);
  const Eigen::Matrix3d rotation = moved.topLeftCorner<3, 3>();
  EXPECT_LT((rotation - Eigen::Matrix3d::Identity()).norm(), 1e-9);
}

TEST(SoftCarrier, GoesAlongWithThePushOfBonesOnThePart) {
  const Eigen::RowVector3d push(3, -2, 1);
  ScenePose pose;
  pose.pushes["tendon"] =
      Points(push.replicate(Tendon().coarse_rest.rows(), 1));
  const Matrix4d moved = TransformOf(Carrier(), pose);
  EXPECT_LT((moved.topRightCorner<3, 1>() - push.transpose()).norm(), 1e-9);
  EXPECT_LT((moved.topLeftCorner<3, 3>() - Eigen::Matrix3d::Identity()).norm(),
            1e-9);
}

}  // namespace
}  // namespace musclewarp
