// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/paper_contact/contact_body.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "support/meshes.h"

namespace musclewarp {
namespace {

Eigen::Matrix4d SomeMotion() {
  Eigen::Matrix4d motion = Eigen::Matrix4d::Identity();
  motion.topLeftCorner<3, 3>() =
      Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 3).normalized())
          .toRotationMatrix();
  motion.topRightCorner<3, 1>() << 5, -20, 7;
  return motion;
}

}  // namespace

TEST(ContactBody, AnObstacleAnswersWhereItIs) {
  const ContactShape shape("bone", Icosphere(10, 2), 1);
  const ContactBody obstacle = ContactBody::Obstacle(shape, SomeMotion());
  for (Eigen::Index v = 0; v < shape.rest.rows(); ++v) {
    const Eigen::Vector4d p =
        SomeMotion() * shape.rest.row(v).transpose().homogeneous();
    // Rounding of coordinates of size 20.
    EXPECT_LT((obstacle.points().row(v).transpose() - p.head<3>()).norm(),
              1e-12);
  }
  const ContactShape moved("moved", {obstacle.points(), shape.triangles}, 1);
  const ContactBody expected =
      ContactBody::Obstacle(moved, Eigen::Matrix4d::Identity());
  const Points queries =
      Icosphere(9, 2).points.rowwise() + Eigen::RowVector3d(8, -16, 9);
  EXPECT_EQ(obstacle.Inside(queries), expected.Inside(queries));
  EXPECT_FALSE(obstacle.Inside(queries).empty());
  const Eigen::RowVector3d direction =
      Eigen::RowVector3d(1, 2, -1).normalized();
  for (const Eigen::RowVector3d p : queries.rowwise()) {
    // Rotated there and back: rounding of coordinates of size 20.
    EXPECT_NEAR(
        obstacle.Closest(p).distance, expected.Closest(p).distance, 1e-12);
    EXPECT_LT((obstacle.Closest(p).point - expected.Closest(p).point).norm(),
              1e-10);
    const double way = expected.DistanceAlong(p, direction);
    if (std::isfinite(way)) {
      EXPECT_NEAR(obstacle.DistanceAlong(p, direction), way, 1e-9);
    }
  }
  EXPECT_NEAR(obstacle.capsule().radius, expected.capsule().radius, 1e-9);
}

TEST(ContactBody, AMuscleAnswersWhereItWent) {
  const ContactShape shape("muscle", Icosphere(10, 2), 1);
  ContactBody body = ContactBody::Deformable(shape, 1);
  const Eigen::RowVector3d far(100, 0, 0);
  const Points centre = Points::Zero(1, 3);
  EXPECT_EQ(body.Inside(centre).size(), 1u);
  EXPECT_NEAR(body.Closest(far).distance, 90, 1e-9);
  body.MoveTo(shape.rest.rowwise() + far);
  EXPECT_TRUE(body.Inside(centre).empty());
  EXPECT_NEAR(body.Closest(Eigen::RowVector3d::Zero()).distance, 90, 1e-9);
  EXPECT_NEAR(
      body.DistanceAlong(Eigen::RowVector3d::Zero(), {1, 0, 0}), 90, 1e-9);
  EXPECT_NEAR(body.capsule().start.x(), 100, 10);
}

}  // namespace musclewarp
