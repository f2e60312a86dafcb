// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certificate/push_chains.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace musclewarp {
namespace {

using ::testing::ElementsAre;

PairDepth BoneIn(int muscle, double depth) { return {muscle, 0, true, depth}; }
PairDepth Between(int a, int b, double depth) { return {a, b, false, depth}; }

TEST(FarthestPushes, AreTheDeepestOverlapOfAMuscleAlone) {
  const auto pushes =
      FarthestPushes(2, {BoneIn(0, 3), BoneIn(0, 5), BoneIn(1, 2)}, {});
  EXPECT_EQ(pushes[0].depth, 5);
  EXPECT_THAT(pushes[0].muscles, ElementsAre(0));
  EXPECT_EQ(pushes[1].depth, 2);
}

TEST(FarthestPushes, AreZeroWithoutOverlaps) {
  const auto pushes = FarthestPushes(2, {}, {{0, 1}});
  for (const PushChain& push : pushes) EXPECT_EQ(push.depth, 0);
}

TEST(FarthestPushes, AddTheDepthsAlongAChain) {
  const auto pushes =
      FarthestPushes(3, {BoneIn(0, 6), Between(0, 1, 2), Between(1, 2, 1)}, {});
  EXPECT_EQ(pushes[2].depth, 9);
  EXPECT_THAT(pushes[2].muscles, ElementsAre(0, 1, 2));
  EXPECT_EQ(pushes[1].depth, 8);
  // A push comes back only by another way: the overlap of 0 and 1 counts once.
  EXPECT_EQ(pushes[0].depth, 6);
}

TEST(FarthestPushes, GoThroughMusclesThatOnlyTouch) {
  const auto pushes = FarthestPushes(2, {BoneIn(0, 6)}, {{0, 1}});
  EXPECT_EQ(pushes[1].depth, 6);
  EXPECT_THAT(pushes[1].muscles, ElementsAre(0, 1));
  // Without touching they do not.
  EXPECT_EQ(FarthestPushes(2, {BoneIn(0, 6)}, {})[1].depth, 0);
}

TEST(FarthestPushes, HaveNoMoreMusclesThanAllowed) {
  const std::vector<PairDepth> overlaps = {
      BoneIn(0, 10), Between(0, 1, 1), Between(1, 2, 1), Between(2, 3, 1)};
  EXPECT_EQ(FarthestPushes(4, overlaps, {}, 4)[3].depth, 13);
  // Without the first one, it is the overlap with that one which counts.
  EXPECT_EQ(FarthestPushes(4, overlaps, {}, 3)[3].depth, 3);
  EXPECT_EQ(FarthestPushes(4, overlaps, {}, 1)[3].depth, 1);
}

TEST(FarthestPushes, DoNotDependOnTheOrderOfOverlaps) {
  const auto a =
      FarthestPushes(3, {BoneIn(2, 4), Between(0, 1, 2), Between(1, 2, 3)}, {});
  const auto b =
      FarthestPushes(3, {Between(1, 2, 3), Between(0, 1, 2), BoneIn(2, 4)}, {});
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(a[i].depth, b[i].depth);
    EXPECT_EQ(a[i].muscles, b[i].muscles);
  }
}

}  // namespace
}  // namespace musclewarp
