// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/hip_joint.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "joints/hand_made_shapes.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// Points are exact, so that fits are off by what they stop at.
constexpr double kFitted = 1e-3;  // mm

constexpr double kHead = 23, kSocket = 26;  // mm, radii

// A socket about the head of the sound femur, moved by a way, as a hip bone: 70
// degrees about its middle.
SurfacePoints SocketMovedBy(const Eigen::Vector3d& way) {
  return Hollow(IdealCap({SoundFemur().head->sphere.center + way, kSocket},
                         {0.2, 0, 1},
                         RadiansOf(70),
                         6000));
}

Limb LimbWithHipBone(const SurfacePoints& hip_bone) {
  Limb limb;
  limb.surfaces[BoneKind::kHipBone] = hip_bone;
  limb.image_axes = AxesOfLps();
  return limb;
}

TEST(FindHip, OfAHeadInItsSocketIsGood) {
  const FoundJoint hip =
      FindHip(LimbWithHipBone(SocketMovedBy({0, 0, 0})), SoundFemur());
  EXPECT_EQ(hip.verdict.quality, JointQuality::kGood);
  EXPECT_THAT(hip.verdict.reasons, IsEmpty());
  EXPECT_EQ(hip.kind, JointKind::kHip);
  EXPECT_EQ(hip.center, SoundFemur().head->sphere.center);
  ASSERT_EQ(hip.shapes.size(), 2u);
  EXPECT_FALSE(hip.shapes[0].is_on_parent);
  EXPECT_EQ(hip.shapes[0].radius, kHead);
  EXPECT_TRUE(hip.shapes[1].is_on_parent);
  EXPECT_NEAR(hip.shapes[1].radius, kSocket, kFitted);
  EXPECT_LT((hip.shapes[1].center - hip.center).norm(), kFitted);
}

// A pelvis has the sockets, too, unless there is a hip bone.
TEST(FindHip, TakesThePelvisIfThereIsNoHipBone) {
  Limb limb = LimbWithHipBone(SocketMovedBy({0, 0, 0}));
  limb.surfaces[BoneKind::kPelvis] = SocketMovedBy({0, 0, 5});
  EXPECT_EQ(FindHip(limb, SoundFemur()).verdict.quality, JointQuality::kGood);
  limb.surfaces.erase(BoneKind::kHipBone);
  EXPECT_EQ(FindHip(limb, SoundFemur()).verdict.quality, JointQuality::kWeak);
}

TEST(FindHip, IsWeakBesideItsSocket) {
  const auto moved_by = [](double way) {
    return FindHip(LimbWithHipBone(SocketMovedBy({way, 0, 0})), SoundFemur())
        .verdict;
  };
  EXPECT_EQ(moved_by(2.5).quality, JointQuality::kGood);
  EXPECT_EQ(moved_by(3.5).quality, JointQuality::kWeak);
  EXPECT_THAT(moved_by(3.5).reasons,
              ElementsAre(HasSubstr("socket is 3.5 mm off")));
}

// The middle of the socket is above the head.
TEST(FindHip, FailsAwayFromTheHipBone) {
  const auto with_plate_at = [](double distance) {
    const Eigen::Vector3d top =
        SoundFemur().head->sphere.center + Eigen::Vector3d(0, 0, distance);
    // It looks away from the head: no socket.
    return FindHip(
        LimbWithHipBone(IdealCap({top - Eigen::Vector3d(0, 0, 40), 40},
                                 Eigen::Vector3d::UnitZ(),
                                 RadiansOf(20),
                                 20000)),
        SoundFemur());
  };
  // The plate bends towards the head by 2.4 mm at its rim, where it is 14 mm
  // aside.
  const FoundJoint near = with_plate_at(1.5 * kHead);
  EXPECT_EQ(near.verdict.quality, JointQuality::kWeak);
  EXPECT_THAT(near.verdict.reasons, ElementsAre(HasSubstr("no socket")));
  EXPECT_EQ(near.shapes.size(), 1u);
  const FoundJoint far = with_plate_at(1.75 * kHead);
  EXPECT_EQ(far.verdict.quality, JointQuality::kFailed);
  EXPECT_THAT(far.verdict.reasons, ElementsAre(HasSubstr("away from")));
  EXPECT_EQ(far.shapes.size(), 1u);
}

TEST(FindHip, IsAsGoodAsTheHead) {
  const Limb limb = LimbWithHipBone(SocketMovedBy({0, 0, 0}));
  FemurShape femur = SoundFemur();
  femur.best_coverage = 0.40;
  const FoundJoint cut = FindHip(limb, femur);
  EXPECT_EQ(cut.verdict.quality, JointQuality::kWeak);
  EXPECT_THAT(cut.verdict.reasons, ElementsAre(HasSubstr("covers 40 %")));
  femur = SoundFemur();
  femur.head->spread = 0.9;
  const FoundJoint rough = FindHip(limb, femur);
  EXPECT_EQ(rough.verdict.quality, JointQuality::kWeak);
  EXPECT_THAT(rough.verdict.reasons, ElementsAre(HasSubstr("by 0.9 mm")));
  femur = SoundFemur();
  femur.head.reset();
  for (const double coverage : {0.24, 1.0}) {
    femur.best_coverage = coverage;
    const FoundJoint none = FindHip(limb, femur);
    EXPECT_EQ(none.verdict.quality, JointQuality::kFailed);
    EXPECT_THAT(none.shapes, IsEmpty());
  }
}

// Right femur: forward, up, and to the right at right angles to it.
TEST(FindHip, HasTheAxesOfWhatIsThere) {
  const Eigen::Matrix3d of_femur = *SoundFemur().Axes();
  EXPECT_LT((of_femur.col(1) - Eigen::Vector3d(40, 0, 400).normalized()).norm(),
            1e-12);
  EXPECT_LT((of_femur.col(0) + Eigen::Vector3d::UnitY()).norm(), 1e-12);
  const Eigen::Matrix3d of_pelvis = RandomMotion(5).rotation();
  Limb limb = LimbWithHipBone(SocketMovedBy({0, 0, 0}));
  limb.pelvis_axes = of_pelvis;
  FoundJoint hip = FindHip(limb, SoundFemur());
  EXPECT_EQ(hip.parent_axes, of_pelvis);
  EXPECT_EQ(hip.child_axes, of_femur);
  limb.pelvis_axes.reset();
  hip = FindHip(limb, SoundFemur());
  EXPECT_EQ(hip.parent_axes, AxesOfLps());
  EXPECT_EQ(hip.child_axes, of_femur);
  limb.image_axes.reset();
  hip = FindHip(limb, SoundFemur());
  EXPECT_EQ(hip.parent_axes, of_femur);
  EXPECT_EQ(hip.child_axes, of_femur);
  FemurShape upper = SoundFemur();
  upper.knee.reset();
  limb.image_axes = AxesOfLps();
  hip = FindHip(limb, upper);
  EXPECT_EQ(hip.parent_axes, AxesOfLps());
  EXPECT_EQ(hip.child_axes, AxesOfLps());
  EXPECT_EQ(hip.verdict.quality, JointQuality::kGood);
  limb.image_axes.reset();
  hip = FindHip(limb, upper);
  EXPECT_EQ(hip.parent_axes, Eigen::Matrix3d::Identity());
  EXPECT_THAT(hip.verdict.reasons, ElementsAre(HasSubstr("axes are those")));
}

}  // namespace
}  // namespace musclewarp
