// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/screw_motion.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "scene/transform_checks.h"

namespace musclewarp {
namespace {

using Eigen::Matrix4d;
using Eigen::Vector3d;

const Vector3d kSocket(30, -800, 120);

// A turn by an angle (rad) about an axis through the socket, and a slide (mm)
// along the axis.
Matrix4d Motion(const Vector3d& axis, double angle, double slide) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
  Matrix4d motion = Matrix4d::Identity();
  motion.topLeftCorner<3, 3>() = turn;
  motion.topRightCorner<3, 1>() =
      kSocket - turn * kSocket + slide * axis.normalized();
  return motion;
}

TEST(ScrewMotion, EndsAreTheIdentityAndTheMotion) {
  const Matrix4d motion = Motion({1, 2, 3}, 0.7, 15);
  const ScrewMotion screw(motion);
  EXPECT_LT(Difference(screw.Part(0), Matrix4d::Identity()),
            kTransformRounding);
  EXPECT_LT(Difference(screw.Part(1), motion), kTransformRounding);
}

TEST(ScrewMotion, PartsAreTurnsAboutTheSameAxis) {
  const Vector3d axis(1, 2, 3);
  const ScrewMotion screw(Motion(axis, 0.7, 15));
  for (const double share : {0.25, 0.5, 0.9}) {
    EXPECT_LT(
        Difference(screw.Part(share), Motion(axis, share * 0.7, share * 15)),
        kTransformRounding);
  }
}

TEST(ScrewMotion, PartsFollowOnEachOther) {
  const ScrewMotion screw(Motion({-1, 0.5, 2}, 2.5, -40));
  EXPECT_LT(Difference(screw.Part(0.3) * screw.Part(0.45), screw.Part(0.75)),
            kTransformRounding);
}

TEST(ScrewMotion, WithoutATurnIsAStraightSlide) {
  Matrix4d motion = Matrix4d::Identity();
  motion.topRightCorner<3, 1>() << 3, 4, 5;
  const Matrix4d half = ScrewMotion(motion).Part(0.5);
  EXPECT_TRUE((half.topLeftCorner<3, 3>().isIdentity(0)));
  EXPECT_EQ((half.topRightCorner<3, 1>()), Vector3d(1.5, 2, 2.5));
}

TEST(ScrewMotion, HoldsForHalfATurn) {
  const Matrix4d motion = Motion({0, 0, 1}, M_PI, 10);
  const ScrewMotion screw(motion);
  EXPECT_LT(Difference(screw.Part(1), motion), kTransformRounding);
  // Half way the socket is still on the axis.
  const Vector3d socket = (screw.Part(0.5) * kSocket.homogeneous()).head<3>();
  EXPECT_LT((socket - kSocket - Vector3d(0, 0, 5)).norm(), kTransformRounding);
}

}  // namespace
}  // namespace musclewarp
