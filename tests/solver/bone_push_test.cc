// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/bone_push.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <memory>
#include <vector>

#include "musclewarp/mesh/transformed.h"
#include "musclewarp/scene/perturbed_poses.h"
#include "musclewarp/solver/bone_push_rates.h"
#include "musclewarp/solver/bone_touches.h"
#include "musclewarp/solver/muscle_model.h"
#include "musclewarp/solver/muscle_target.h"
#include "support/meshes.h"
#include "support/muscles.h"

namespace musclewarp {
namespace {

// A ball of bone of the body "ball" beside the spindle, 1 mm from it at rest.
std::vector<BoneField> Ball() {
  const TriangleSoup surface = SphereAt({33, 0, 0}, 20, 4);
  return {{"ball", std::make_shared<const DistanceField>(surface, 3, 6)}};
}

ScenePose BallAt(const Eigen::Vector3d& moved, double turn = 0) {
  Eigen::Matrix4d motion = Eigen::Matrix4d::Identity();
  motion.topLeftCorner<3, 3>() =
      Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  motion.topRightCorner<3, 1>() = moved;
  ScenePose pose;
  pose.bodies["ball"] = motion;
  return pose;
}

Points FreeIn(const MuscleModel& model, const ScenePose& pose) {
  return UnconstrainedMinimizer(model, TargetOf(model, pose, {}));
}

Points PushIn(const BonePush& push,
              const MuscleModel& model,
              const ScenePose& pose) {
  return FollowPush(push, {{}, pose}, {model.coarse_rest, FreeIn(model, pose)})
      .back();
}

double DeepestIn(const BonePush& push,
                 const ScenePose& pose,
                 const Points& coarse) {
  double deepest = 0;
  const Points at_rest = Transformed(push.fine_from_coarse * coarse,
                                     RigidInverse(pose.bodies.at("ball")));
  DistanceField::Value value;
  for (Eigen::Index v = 0; v < at_rest.rows(); ++v) {
    if (!push.bones[0].field->IsBelow(0, at_rest.row(v), &value)) continue;
    deepest = std::max(deepest, -value.distance);
  }
  return deepest;
}

class BonePushTest : public testing::Test {
 protected:
  const MuscleModel model_ = SpindleModel();
  const std::shared_ptr<const BonePush> push_ =
      PrepareBonePush({}, Ball(), model_);
};

TEST_F(BonePushTest, IsNoneAtRest) {
  EXPECT_TRUE(PushIn(*push_, model_, BallAt({0, 0, 0})).isZero(0));
}

TEST_F(BonePushTest, IsNoneWhereNothingTouches) {
  EXPECT_TRUE(PushIn(*push_, model_, BallAt({30, 0, 0})).isZero(0));
}

TEST_F(BonePushTest, TakesTheMuscleOutOfTheBone) {
  const ScenePose pose = BallAt({-8, 1, 2});
  const Points free = FreeIn(model_, pose);
  const Points push = PushIn(*push_, model_, pose);
  EXPECT_GT(DeepestIn(*push_, pose, free), 6);
  // What is left: a force of the size of the push against the stiffness.
  EXPECT_LT(DeepestIn(*push_, pose, free + push), 1.5);
}

TEST_F(BonePushTest, KeepsTheDepthAtRest) {
  const TriangleSoup surface = SphereAt({28, 0, 0}, 20, 4);
  const auto deep = PrepareBonePush(
      {},
      {{"ball", std::make_shared<const DistanceField>(surface, 3, 6)}},
      model_);
  EXPECT_TRUE(PushIn(*deep, model_, BallAt({0, 0, 0})).isZero(0));
  EXPECT_FALSE(PushIn(*deep, model_, BallAt({-1, 0, 0})).isZero(0));
}

// The forces of the bone are in balance with the energy of the shape.
TEST_F(BonePushTest, IsAMinimum) {
  const ScenePose pose = BallAt({-8, 1, 2});
  const Points free = FreeIn(model_, pose);
  const Points push = PushIn(*push_, model_, pose);
  Points forces = Points::Zero(push_->fine_from_coarse.rows(), 3);
  for (const BoneTouch& touch :
       BoneTouches(*push_).At(pose, push_->fine_from_coarse * (free + push))) {
    forces.row(touch.sample) +=
        ForceAt(*push_, touch.lack).force * touch.normal;
  }
  const Points balanced = push_->reach.transpose() * forces;
  EXPECT_LT((balanced - push).rowwise().norm().maxCoeff(), 1e-3);  // mm
}

// Law: what moves everything moves the push along.
TEST_F(BonePushTest, TurnsAlongWithEverything) {
  ScenePose pose = BallAt({-8, 1, 2});
  const Points free = FreeIn(model_, pose);
  const Points push = PushIn(*push_, model_, pose);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.3, Eigen::Vector3d(1, -2, 2).normalized())
          .toRotationMatrix();
  Eigen::Matrix4d motion = Eigen::Matrix4d::Identity();
  motion.topLeftCorner<3, 3>() = turn;
  motion.topRightCorner<3, 1>() << 200, -300, 50;
  ScenePose rest;
  rest.bodies["ball"] = motion;
  pose.bodies["ball"] = motion * pose.bodies["ball"];
  const Points turned = FollowPush(*push_,
                                   {rest, pose},
                                   {Transformed(model_.coarse_rest, motion),
                                    Transformed(free, motion)})
                            .back();
  EXPECT_LT((turned - push * turn.transpose()).cwiseAbs().maxCoeff(), 1e-8);
}

// The push does not hang on where the way has poses.
TEST_F(BonePushTest, DoesNotDependOnThePosesOfTheWay) {
  const Points free = FreeIn(model_, {});
  const auto after = [&](int steps) {
    std::vector<ScenePose> way;
    for (int k = 0; k <= steps; ++k) {
      way.push_back(BallAt(Eigen::Vector3d(-9, 1, 2) * k / steps));
    }
    return FollowPush(*push_, way, std::vector<Points>(steps + 1, free)).back();
  };
  EXPECT_LT((after(3) - after(12)).cwiseAbs().maxCoeff(), 1e-3);  // mm
}

// Law: the derivative is that of the push, with the ball moving and turning,
// but for what the flow is behind by one step of 24.
TEST_F(BonePushTest, HasTheRatesOfItsDifferences) {
  const auto pose_at = [](double q) {
    return BallAt({-8 - 5 * q, 1 + 3 * q, 2 - 4 * q}, 0.3 * q);
  };
  const auto bent = [&](double q) {  // the shape, too, changes
    ScenePose pose = pose_at(q);
    pose.bodies["femur"] = BentPose(0.2 * q).bodies.at("femur");
    return pose;
  };
  constexpr double kStep = PerturbedPoses::kStep;
  const ScenePose here = bent(0.1), before = bent(0.1 - kStep),
                  after = bent(0.1 + kStep);
  const PushMotion motion = {
      (FreeIn(model_, after) - FreeIn(model_, before)) / (2 * kStep),
      {RateBetween(before.bodies.at("ball"), after.bodies.at("ball"))}};
  const Points rate = PushRates(*push_,
                                here,
                                FreeIn(model_, here),
                                PushIn(*push_, model_, here),
                                {motion})[0];
  const Points difference =
      (PushIn(*push_, model_, after) - PushIn(*push_, model_, before)) /
      (2 * kStep);
  ASSERT_GT(difference.cwiseAbs().maxCoeff(), 1);
  EXPECT_LT((rate - difference).cwiseAbs().maxCoeff(),
            1e-3 * difference.cwiseAbs().maxCoeff());
}

}  // namespace
}  // namespace musclewarp
