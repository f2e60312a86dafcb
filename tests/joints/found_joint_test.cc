// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/found_joint.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "joints/ideal_surfaces.h"

namespace musclewarp {
namespace {

// Angles and their sines and cosines, to rounding.
constexpr double kScanTolerance = 1e-12;  // rad

// The turns about the axes of the coordinates, one after the other.
Eigen::Matrix3d TurnedBy(const FoundJoint& joint,
                         const std::vector<double>& values) {
  const auto coordinates = CoordinatesOf(joint.kind, joint.side);
  Eigen::Matrix3d turned = Eigen::Matrix3d::Identity();
  for (size_t i = 0; i < coordinates.size(); ++i) {
    turned =
        turned *
        Eigen::AngleAxisd(values[i], coordinates[i].axis).toRotationMatrix();
  }
  return turned;
}

TEST(ScanCoordinates, TurnTheFrameOfTheParentToThatOfTheChild) {
  const Eigen::Matrix3d axes = RandomMotion(7).rotation();
  for (const JointKind kind : AllJointKinds()) {
    for (const Side side : {Side::kRight, Side::kLeft}) {
      FoundJoint joint;
      joint.kind = kind;
      joint.side = side;
      joint.parent_axes = axes;
      std::vector<double> values = {0.4, -0.3, 0.2};
      values.resize(CoordinatesOf(kind, side).size());
      joint.child_axes = axes * TurnedBy(joint, values);
      const std::vector<double> found = ScanCoordinates(joint);
      ASSERT_EQ(found.size(), values.size()) << joint.name();
      for (size_t i = 0; i < values.size(); ++i) {
        EXPECT_NEAR(found[i], values[i], kScanTolerance) << joint.name();
      }
    }
  }
}

TEST(CoordinatesOf, TurnTheOtherWayInAMirror) {
  const Eigen::Vector3d mirror(1, 1, -1);  // of z, which is to the right
  for (const JointKind kind : AllJointKinds()) {
    const auto right = CoordinatesOf(kind, Side::kRight);
    const auto left = CoordinatesOf(kind, Side::kLeft);
    for (size_t i = 0; i < right.size(); ++i) {
      const Eigen::Matrix3d turned =
          Eigen::AngleAxisd(0.3, right[i].axis).toRotationMatrix();
      EXPECT_LT((mirror.asDiagonal() * turned * mirror.asDiagonal() -
                 Eigen::AngleAxisd(0.3, left[i].axis).toRotationMatrix())
                    .norm(),
                kScanTolerance)
          << right[i].name;
    }
  }
}

TEST(JointVerdict, OnlyEverGetsWorse) {
  JointVerdict verdict;
  EXPECT_EQ(verdict.quality, JointQuality::kGood);
  verdict.Fail("broken");
  verdict.Weaken("bent");
  EXPECT_EQ(verdict.quality, JointQuality::kFailed);
  EXPECT_EQ(verdict.reasons.size(), 2u);
}

}  // namespace
}  // namespace musclewarp
