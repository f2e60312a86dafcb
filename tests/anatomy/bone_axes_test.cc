// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/anatomy/bone_axes.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <string>
#include <vector>

#include "musclewarp/anatomy/bone_names.h"
#include "musclewarp/anatomy/standing_bones.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// The frame of the bones below: forward, up and right are its axes.
const Matrix3d kOwnFrame = Matrix3d::Identity();

// A box of a bone where the bone lies in a standing body, with its long axis
// upright.
MeasuredBone StandingBox(const std::string& name, double length) {
  TriangleSoup box = Box(20, length, 20);
  const Vector3d middle = FindStandingBone(name)->Middle();
  const Eigen::RowVector3d own =
      (box.points.colwise().minCoeff() + box.points.colwise().maxCoeff()) / 2;
  box.points.rowwise() += middle.transpose() - own;
  return Measured(BoneOfName(name, box));
}

std::vector<MeasuredBone> Leg() {
  return {StandingBox("femur", 440),
          StandingBox("tibia", 345),
          StandingBox("fibula", 350),
          StandingBox("talus", 30),
          StandingBox("calcaneus", 40),
          StandingBox("metatarsal_1", 30),
          StandingBox("metatarsal_5", 30)};
}

void Turn(const Matrix3d& turn, std::vector<MeasuredBone>* bones) {
  for (MeasuredBone& bone : *bones) {
    bone.bone.mesh.points = bone.bone.mesh.points * turn.transpose();
    bone = Measured(bone.bone);
  }
}

// The largest difference of two matrices of unit vectors.
double Difference(const Matrix3d& a, const Matrix3d& b) {
  return (a - b).cwiseAbs().maxCoeff();
}

TEST(BoneAxes, AreThoseOfTheStandingBody) {
  // The boxes lie where the table has them, so that the fit is exact.
  for (size_t bone : {1, 4}) {
    const BoneAxes axes = AxesAt(bone, Leg(), Side::kRight, kOwnFrame);
    EXPECT_TRUE(axes.are_from_bones);
    EXPECT_LT(Difference(axes.directions, Matrix3d::Identity()), 1e-6);
  }
}

TEST(BoneAxes, TurnWithTheBonesWhateverTheImageSays) {
  const Matrix3d turn =
      Eigen::AngleAxisd(2.1, Vector3d(1, -2, 0.5).normalized())
          .toRotationMatrix();
  std::vector<MeasuredBone> bones = Leg();
  Turn(turn, &bones);
  const BoneAxes axes = AxesAt(1, bones, Side::kRight, kOwnFrame);
  EXPECT_TRUE(axes.are_from_bones);
  EXPECT_LT(Difference(axes.directions, turn), 1e-6);
}

TEST(BoneAxes, AreMirroredOnTheLeft) {
  const Matrix3d mirror = Vector3d(1, 1, -1).asDiagonal();
  std::vector<MeasuredBone> bones = Leg();
  Turn(mirror, &bones);
  EXPECT_LT(
      Difference(AxesAt(1, bones, Side::kLeft, kOwnFrame).directions, mirror),
      1e-6);
  // The bones tell the side, too.
  EXPECT_LT(Difference(AxesAt(1, bones, {}, kOwnFrame).directions, mirror),
            1e-6);
  EXPECT_LT(Difference(AxesAt(1, Leg(), {}, kOwnFrame).directions,
                       Matrix3d::Identity()),
            1e-6);
}

TEST(BoneAxes, OfTheShankHardlyFollowAPointedFoot) {
  std::vector<MeasuredBone> bones = Leg();
  const Matrix3d turn =
      Eigen::AngleAxisd(-0.7, Vector3d::UnitZ()).toRotationMatrix();
  const Vector3d ankle(60, 70, 80);
  for (size_t bone = 3; bone < bones.size(); ++bone) {
    Points& points = bones[bone].bone.mesh.points;
    points.rowwise() -= ankle.transpose();
    points = points * turn.transpose();
    points.rowwise() += ankle.transpose();
    bones[bone] = Measured(bones[bone].bone);
  }
  // 40 degrees at the ankle turn the shank's directions by less than 6, and
  // the foot's by more than 30.
  const Vector3d shank =
      AxesAt(1, bones, Side::kRight, kOwnFrame).directions.col(0);
  const Vector3d foot =
      AxesAt(4, bones, Side::kRight, kOwnFrame).directions.col(0);
  EXPECT_GT(shank.x(), std::cos(0.1));
  EXPECT_LT(foot.x(), std::cos(0.5));
}

TEST(BoneAxes, ComeFromTheImageWhereTheBonesLeaveThemOpen) {
  const std::vector<MeasuredBone> alone = {StandingBox("tibia", 345)};
  const BoneAxes axes = AxesAt(0, alone, Side::kRight, kOwnFrame);
  EXPECT_FALSE(axes.are_from_bones);
  EXPECT_LT(Difference(axes.directions, Matrix3d::Identity()), 1e-6);
}

}  // namespace
}  // namespace musclewarp
