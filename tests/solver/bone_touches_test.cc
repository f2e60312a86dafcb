// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/bone_touches.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <vector>

#include "support/meshes.h"

namespace musclewarp {
namespace {

// A ball of bone of 20 mm, and samples in a block around it that keep 1 mm.
BonePush PushOfBlock() {
  BonePush push;
  push.bones = {
      {"ball", std::make_shared<const DistanceField>(Icosphere(20, 4), 3, 15)}};
  push.fine_from_coarse.resize(1000, 1);
  push.clearances.setConstant(1000, 1, 1.0);
  push.stiffness = 3;
  return push;
}

Points Block() {
  constexpr double kSpacing = 7;  // mm
  Points places(1000, 3);
  int i = 0;
  for (int x = 0; x < 10; ++x) {
    for (int y = 0; y < 10; ++y) {
      for (int z = 0; z < 10; ++z) {
        places.row(i++) << kSpacing * x - 30, kSpacing * y - 32,
            kSpacing * z - 31;
      }
    }
  }
  return places;
}

ScenePose BallAt(double part) {
  Eigen::Matrix4d motion = Eigen::Matrix4d::Identity();
  motion.topLeftCorner<3, 3>() =
      Eigen::AngleAxisd(part, Eigen::Vector3d::UnitY()).toRotationMatrix();
  motion.topRightCorner<3, 1>() << 25 * part, -20 * part, 5;
  ScenePose pose;
  pose.bodies["ball"] = motion;
  return pose;
}

// Law: where the samples were before has no influence, however fast they come.
TEST(BoneTouches, DoNotDependOnWhatWasAskedBefore) {
  const BonePush push = PushOfBlock();
  for (const int steps : {2, 7, 60}) {
    BoneTouches along(push);
    for (int k = 0; k <= steps; ++k) {
      const ScenePose pose = BallAt(static_cast<double>(k) / steps);
      const double margin = k % 3;
      const auto found = along.At(pose, Block(), margin);
      const auto afresh = BoneTouches(push).At(pose, Block(), margin);
      EXPECT_FALSE(afresh.empty());
      ASSERT_EQ(found.size(), afresh.size()) << k << " of " << steps;
      for (size_t i = 0; i < found.size(); ++i) {
        EXPECT_EQ(found[i].sample, afresh[i].sample);
        EXPECT_EQ(found[i].lack, afresh[i].lack);
      }
    }
  }
}

TEST(BoneTouches, AreWhatLacksOfTheDistanceKept) {
  const BonePush push = PushOfBlock();
  const Points places = Block();
  std::vector<bool> touches(places.rows(), false);
  for (const BoneTouch& touch : BoneTouches(push).At({}, places)) {
    touches[touch.sample] = true;
    // The field is smooth: less curved than the ball by a tenth of a mm, and
    // more in its middle.
    const double distance = places.row(touch.sample).norm() - 20;
    if (distance > -15) {
      EXPECT_NEAR(touch.lack, 1 - distance, 0.5);
    }
  }
  for (Eigen::Index v = 0; v < places.rows(); ++v) {
    const double distance = places.row(v).norm() - 20;
    if (std::abs(distance - 1) > 0.5) {
      EXPECT_EQ(touches[v], distance < 1) << v;
    }
  }
}

TEST(BoneTouches, ForcesAreTheSlopesOfTheirEnergy) {
  const BonePush push = PushOfBlock();
  constexpr double kStep = 1e-5;
  for (const double lack : {-0.5, 0.3, 0.999, 1.001, 4.0}) {
    const BoneForce before = ForceAt(push, lack - kStep);
    const BoneForce here = ForceAt(push, lack);
    const BoneForce after = ForceAt(push, lack + kStep);
    // The truncation of a difference of cubics, and rounding.
    EXPECT_NEAR(here.force, (after.energy - before.energy) / (2 * kStep), 1e-8);
    EXPECT_NEAR(
        here.stiffness, (after.force - before.force) / (2 * kStep), 1e-8);
  }
}

}  // namespace
}  // namespace musclewarp
