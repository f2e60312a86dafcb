// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/knee_joint.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "joints/hand_made_shapes.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// A tibia whose points lie on a ray from the middle of the knee, from `gap` mm
// on, down and somewhat back.
Limb LimbWithTibia(double gap) {
  const Eigen::Vector3d down = Eigen::Vector3d(0, 0.2, -1).normalized();
  Limb limb;
  limb.surfaces[BoneKind::kTibia] = PointsBetween(gap * down, 380 * down);
  return limb;
}

TEST(FindKnee, HasTheAxesOfFemurAndTibia) {
  const FoundJoint knee = FindKnee(LimbWithTibia(25), SoundFemur());
  EXPECT_EQ(knee.verdict.quality, JointQuality::kGood);
  EXPECT_EQ(knee.center, Eigen::Vector3d::Zero());
  // To the right; up to the head, without what of it is to the side; forward.
  EXPECT_LT((knee.parent_axes - AxesOfLps()).norm(), 1e-12);
  const Eigen::Vector3d up = Eigen::Vector3d(0, -0.2, 1).normalized();
  EXPECT_LT((knee.child_axes.col(1) - up).norm(), 1e-12);
  EXPECT_EQ(knee.child_axes.col(2), knee.parent_axes.col(2));
  // Flexion turns the shank back: it is negative or not as the model has it.
  EXPECT_NEAR(std::abs(ScanCoordinates(knee)[0]), std::atan(0.2), 1e-12);
  ASSERT_EQ(knee.shapes.size(), 1u);
  EXPECT_TRUE(knee.shapes[0].is_on_parent);
  EXPECT_EQ(knee.shapes[0].angle, RadiansOf(120));
}

// Its lower end is the lowest part, not the middle.
TEST(FindKnee, TakesTheLowerEndOfTheTibiaForTheAnkle) {
  Limb limb = LimbWithTibia(25);
  const SurfacePoints straight = PointsBetween({0, 0, -25}, {0, 0, -300}, 2000);
  const SurfacePoints bent = PointsBetween({0, 50, -380}, {0, 60, -380});
  limb.surfaces[BoneKind::kTibia] = Together(straight, bent);
  const FoundJoint knee = FindKnee(limb, SoundFemur());
  EXPECT_LT((knee.child_axes.col(1) - Eigen::Vector3d(0, -55, 380).normalized())
                .norm(),
            1e-12);
}

TEST(FindKnee, OfAPieceGoesUpAlongTheShaft) {
  FemurShape piece = SoundFemur();
  piece.head.reset();
  piece.directions->up = Eigen::Vector3d(0, 0.1, 1).normalized();
  const FoundJoint knee = FindKnee(LimbWithTibia(25), piece);
  EXPECT_LT((knee.parent_axes.col(1) - piece.directions->up).norm(), 1e-12);
}

TEST(FindKnee, FailsWithoutCondylesOrATibiaBesideThem) {
  FemurShape without = SoundFemur();
  without.knee.reset();
  EXPECT_THAT(FindKnee(LimbWithTibia(25), without).verdict.reasons,
              ElementsAre(HasSubstr("no cylinder")));
  EXPECT_TRUE(FindKnee(LimbWithTibia(1.9 * 23), SoundFemur()).IsFound());
  EXPECT_FALSE(FindKnee(LimbWithTibia(2.1 * 23), SoundFemur()).IsFound());
  // By the size of the head, which a child has less of.
  FemurShape child = SoundFemur();
  child.head->sphere.radius = 16;
  EXPECT_FALSE(FindKnee(LimbWithTibia(1.9 * 23), child).IsFound());
}

TEST(FindKnee, ShowsTheCondyleThatCoversLess) {
  FemurShape femur = SoundFemur();
  femur.knee->right_angle = RadiansOf(70);
  EXPECT_EQ(FindKnee(LimbWithTibia(25), femur).shapes[0].angle, RadiansOf(70));
  femur.knee->right_angle = RadiansOf(50);
  EXPECT_EQ(FindKnee(LimbWithTibia(25), femur).verdict.quality,
            JointQuality::kWeak);
}

}  // namespace
}  // namespace musclewarp
