// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/contact_step.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "certified_contact/contact_group.h"
#include "musclewarp/mesh/transformed.h"

namespace musclewarp {
namespace {

// Of coordinates of size 30.
constexpr double kCoordinateRounding = 1e-12;

Eigen::Matrix4d SomeMotion() {
  Eigen::Matrix4d motion = Eigen::Matrix4d::Identity();
  motion.topLeftCorner<3, 3>() =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1).normalized())
          .toRotationMatrix();
  motion.topRightCorner<3, 1>() << 3, -2, 5;
  return motion;
}

TEST(ContactStep, CarriesOffsetsAlong) {
  ContactGroup group = SpheresOverABone();
  // The first muscle has been pushed up by 0.3.
  group.state.points[0].col(2).array() += 0.3;
  std::vector<Points> targets = group.state.targets;
  for (Points& points : targets) points.col(0).array() += 2;
  const ContactStep step = MakeContactStep(
      group.scene, group.state, targets, group.state.bones_from_rest);
  for (int i = 0; i < 2; ++i) {
    EXPECT_LT((step.predicted[i] - group.state.points[i] -
               (targets[i] - group.state.targets[i]))
                  .norm(),
              kCoordinateRounding * step.predicted[i].rows());
  }
}

TEST(ContactStep, KnowsTheRotationOfEveryTriangleInARigidMotion) {
  const ContactGroup group = SpheresOverABone();
  const Eigen::Matrix4d motion = SomeMotion();
  std::vector<Points> targets;
  for (const Points& points : group.state.points) {
    targets.push_back(Transformed(points, motion));
  }
  const ContactStep step =
      MakeContactStep(group.scene, group.state, targets, {motion});
  for (const auto& of_muscle : step.rotations) {
    for (const Eigen::Matrix3d& rotation : of_muscle) {
      // For row vectors: transposed.
      EXPECT_LT((rotation.transpose() - motion.topLeftCorner<3, 3>()).norm(),
                1e-10);
    }
  }
}

TEST(ContactStep, HasTreesBeforeAndWhereItCarries) {
  const ContactGroup group = SpheresOverABone();
  std::vector<Points> targets = group.state.targets;
  targets[1].col(1).array() += 4;
  const ContactStep step = MakeContactStep(
      group.scene, group.state, targets, group.state.bones_from_rest);
  const std::vector<TriangleBvh> predicted = PredictedTrees(step);
  for (int i = 0; i < step.num_muscles(); ++i) {
    const Triangles& triangles = group.scene.muscles[i].triangles;
    for (int f = 0; f < triangles.rows(); ++f) {
      EXPECT_EQ(step.trees_before[i].corners(f),
                CornersOf(group.state.points[i], triangles.row(f)));
      EXPECT_EQ(predicted[i].corners(f),
                CornersOf(step.predicted[i], triangles.row(f)));
    }
  }
}

}  // namespace
}  // namespace musclewarp
