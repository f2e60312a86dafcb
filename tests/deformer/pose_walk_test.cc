// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/deformer/pose_walk.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/small_scene.h"

namespace musclewarp {
namespace {

using ::testing::Optional;

DeformerOptions QuickOptions() {
  DeformerOptions options;
  options.prepare.muscle.hull.coarse_vertices = 60;
  return options;
}

// Five postures on two branches from rest: 0 -> 1 -> 2 and 3 -> 4.
Scene Designed() {
  Scene scene = SmallScene();
  scene.poses.clear();
  for (const double angle : {0.1, 0.2, 0.3, -0.1, -0.2}) {
    scene.poses.push_back(FlexedPose(angle));
    scene.poses.back().name = "posture_" + std::to_string(scene.poses.size());
  }
  scene.is_motion = false;
  scene.design = "grid";
  scene.reached_from = {-1, 0, 1, -1, 3};
  return scene;
}

void ExpectSameFrame(const Frame& a, const Frame& b) {
  EXPECT_EQ(a.index, b.index);
  EXPECT_EQ(a.reached_from, b.reached_from);
  ASSERT_EQ(a.muscles.size(), b.muscles.size());
  for (size_t i = 0; i < a.muscles.size(); ++i) {
    EXPECT_EQ(a.muscles[i].points, b.muscles[i].points) << a.name;
  }
}

TEST(PoseWalk, FramesOfADesignAreTheSameInAnyOrderAndDivision) {
  Deformer deformer(Designed(), QuickOptions());
  PoseWalk all(&deformer);
  std::vector<Frame> frames;
  for (int pose = 0; pose < 5; ++pose) frames.push_back(all.Solve(pose));
  EXPECT_THAT(frames[0].reached_from, Optional(-1));
  EXPECT_THAT(frames[2].reached_from, Optional(1));
  EXPECT_THAT(frames[4].reached_from, Optional(3));
  for (const std::vector<int>& asked :
       {std::vector<int>{4, 2, 0, 1, 3}, {2}, {1, 4}, {2, 2}}) {
    PoseWalk some(&deformer);
    for (const int pose : asked)
      ExpectSameFrame(some.Solve(pose), frames[pose]);
  }
}

TEST(PoseWalk, GoesWhereAMotionGoes) {
  Deformer deformer(Designed(), QuickOptions());
  PoseWalk walk(&deformer);
  const Frame last = walk.Solve(2);
  deformer.Reset();
  for (int pose = 0; pose < 2; ++pose) {
    deformer.MoveTo(deformer.scene().scene.poses[pose]);
  }
  const Frame moved = deformer.MoveTo(deformer.scene().scene.poses[2]);
  EXPECT_EQ(last.muscles[0].points, moved.muscles[0].points);
}

TEST(PoseWalk, SolvesOtherPosesAsTheDeformerDoes) {
  Scene scene = Designed();
  scene.design.clear();
  scene.reached_from.clear();
  Deformer alone(scene, QuickOptions());
  PoseWalk walk(&alone);
  const Frame frame = walk.Solve(1);
  EXPECT_FALSE(frame.reached_from);
  EXPECT_EQ(frame.index, 1);
  EXPECT_EQ(frame.muscles[0].points,
            alone.SolveAlone(scene.poses[1]).muscles[0].points);
}

// Each posture counts as not usable: all start from rest then.
TEST(PoseWalk, PosturesThatAreNotUsableSpoilNoOthers) {
  DeformerOptions options = QuickOptions();
  options.frames.requirements.max_volume_error = 1e-30;
  Deformer deformer(Designed(), options);
  PoseWalk walk(&deformer);
  for (int pose = 0; pose < 3; ++pose) {
    const Frame frame = walk.Solve(pose);
    ASSERT_FALSE(frame.IsUsable());
    EXPECT_THAT(frame.reached_from, Optional(-1));
    deformer.Reset();
    EXPECT_EQ(
        frame.muscles[0].points,
        deformer.MoveTo(deformer.scene().scene.poses[pose]).muscles[0].points);
  }
}

}  // namespace
}  // namespace musclewarp
