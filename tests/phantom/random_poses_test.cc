// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/phantom/random_poses.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "musclewarp/base/angles.h"
#include "musclewarp/phantom/scene_parts.h"

namespace musclewarp::phantom {
namespace {

using Eigen::Matrix4d;
using Eigen::Vector3d;

// Matrices have twelve decimals.
constexpr double kMatrixRounding = 1e-10;

// Two rods end to end along z with a joint between them at z = 105, and a line
// beside it.
class RandomPoses : public ::testing::Test {
 protected:
  RandomPoses() {
    for (const int i : {0, 1}) {
      const Vector3d start(0, 0, 130.0 * i), end(0, 0, 130.0 * i + 80);
      RandomBone bone;
      bone.name = i == 0 ? "upper" : "lower";
      bone.parent = i - 1;
      bone.joint = {0, 0, 105};
      bone.field = Sweep({{start, 12}, {end, 12}});
      bone.mesh =
          MeshOf({bone.name,
                  bone.field,
                  {start - Vector3d(20, 20, 20), end + Vector3d(20, 20, 20)},
                  5,
                  {}},
                 i);
      bones_.push_back(bone);
    }
    ActionLine line;
    line.bodies = {"upper", "lower"};
    line.rest.resize(2, 3);
    line.rest << 14, 0, 40, 14, 0, 170;
    muscle_.ends[1].bone = 1;
    muscle_.lines = {line};
  }

  std::vector<RandomBone> bones_;
  RandomMuscle muscle_;
};

double TurnOf(const Matrix4d& transform) {
  const double cosine = (transform.topLeftCorner<3, 3>().trace() - 1) / 2;
  return DegreesOf(std::acos(std::min(1.0, cosine)));
}

TEST_F(RandomPoses, AreAMotionFromRestOfAtMostSixtyDegrees) {
  for (int seed = 1; seed <= 10; ++seed) {
    RandomDraws draws(seed);
    const std::vector<ScenePose> poses = DrawPoses(bones_, {muscle_}, &draws);
    ASSERT_GE(poses.size(), 3u);
    EXPECT_LE(poses.size(), 5u);
    double last = -1;
    for (const ScenePose& pose : poses) {
      EXPECT_EQ(pose.bodies.at("upper"), Matrix4d(Matrix4d::Identity()));
      const double degrees = TurnOf(pose.bodies.at("lower"));
      EXPECT_GT(degrees, last);
      last = degrees;
    }
    EXPECT_EQ(poses[0].bodies.at("lower"), Matrix4d(Matrix4d::Identity()));
    EXPECT_GE(last, 8 - 1e-6);
    EXPECT_LE(last, 60 + 1e-6);
  }
}

TEST_F(RandomPoses, TurnAboutTheJointAndKeepBonesApart) {
  RandomDraws draws(1);
  for (const ScenePose& pose : DrawPoses(bones_, {muscle_}, &draws)) {
    const Matrix4d& lower = pose.bodies.at("lower");
    EXPECT_LT(
        ((lower * bones_[1].joint.homogeneous()).head<3>() - bones_[1].joint)
            .norm(),
        // Rounding of the matrix times the distance of the joint, 105 mm.
        105 * kMatrixRounding);
    EXPECT_GE(LeastBoneDistance(bones_, {pose.bodies.at("upper"), lower}), 0.5);
  }
}

TEST_F(RandomPoses, KeepTheLengthsOfLinesWithinTheirRange) {
  for (int seed = 1; seed <= 10; ++seed) {
    RandomDraws draws(seed);
    for (const ScenePose& pose : DrawPoses(bones_, {muscle_}, &draws)) {
      const Points moved = MovedLine(muscle_.lines[0], pose.bodies);
      const double ratio = (moved.row(1) - moved.row(0)).norm() / 130;
      EXPECT_GE(ratio, 0.6);
      EXPECT_LE(ratio, 1.5);
    }
  }
}

TEST_F(RandomPoses, ThereAreNoneForABoneThatCannotTurn) {
  // The lower bone is in a tube that leaves it no room.
  const Field lower = bones_[1].field;
  bones_[0].field = Difference(Sphere({0, 0, 170}, 90), Offset(lower, 0.8), 0);
  RandomDraws draws(1);
  EXPECT_TRUE(DrawPoses(bones_, {muscle_}, &draws).empty());
}

}  // namespace
}  // namespace musclewarp::phantom
