// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/ankle_joints.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "joints/hand_made_shapes.h"
#include "support/made_bones.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// The made ankle, whose inner malleolus is on the left of the body, as that of
// a right leg. Its fibula ends at a height of the outer side.
class FindAnkleTest : public ::testing::Test {
 protected:
  FindAnkleTest() {
    static const auto* made = new MadeAnkle(RightAnkle(3, 2));
    static const auto* talus = new SurfacePoints(SampleSurface(made->talus));
    static const auto* tibia = new SurfacePoints(SampleSurface(made->tibia));
    axis_ = made->axis;
    limb_.surfaces[BoneKind::kTalus] = *talus;
    limb_.surfaces[BoneKind::kTibia] = *tibia;
    limb_.image_axes = AxesOfLps();
    // As the joint has it: from the talus to the tibia.
    up_ = (tibia->points.colwise().mean() - talus->points.colwise().mean())
              .transpose()
              .normalized();
    inner_tip_ = 1e9;
    for (int i = 0; i < tibia->size(); ++i) {
      inner_tip_ = std::min(
          inner_tip_, up_.dot(tibia->points.row(i).transpose() - axis_.point));
    }
  }

  // Lets a fibula end at a height above the axis of the dome, mm.
  void AddFibula(double height) {
    const Eigen::Vector3d tip = axis_.point + Eigen::Vector3d(-25, 0, 0) -
                                up_.dot(Eigen::Vector3d(-25, 0, 0)) * up_ +
                                height * up_;
    limb_.surfaces[BoneKind::kFibula] = PointsBetween(tip, tip + 100 * up_);
  }

  // Returns the height of the joint above the axis of the dome, mm.
  double HeightOf(const FoundJoint& joint) const {
    return up_.dot(joint.center - axis_.point);
  }

  Limb limb_;
  FemurShape femur_;
  Axis axis_;
  Eigen::Vector3d up_;
  double inner_tip_ = 0;  // above the axis, mm
};

// As FitAnkle has it (ankle_test.cc): its point is at the middle of the dome,
// whose edges the neck cuts a little.
constexpr double kHeight = 0.5;  // mm

TEST_F(FindAnkleTest, IsTheAxisOfTheDome) {
  const FoundJoint ankle = FindAnkle(limb_, femur_);
  EXPECT_EQ(ankle.verdict.quality, JointQuality::kGood);
  EXPECT_LT(AngleBetween(ankle.parent_axes.col(2), axis_.direction),
            RadiansOf(0.3));
  EXPECT_LT(ankle.parent_axes(0, 2), -0.9);  // to the right
  EXPECT_GT(ankle.parent_axes.col(1).dot(up_), 0.9);
  EXPECT_EQ(ankle.child_axes, ankle.parent_axes);
  EXPECT_NEAR(HeightOf(ankle), 0, kHeight);
  ASSERT_EQ(ankle.shapes.size(), 1u);
  EXPECT_FALSE(ankle.shapes[0].is_on_parent);
  EXPECT_NEAR(ankle.shapes[0].radius, kMadeDomeRadius, 0.2);
}

// Without a talus of its own.
TEST_F(FindAnkleTest, TakesTheFootForTheTalus) {
  const FoundJoint ankle = FindAnkle(limb_, femur_);
  limb_.surfaces[BoneKind::kFoot] = limb_.surfaces[BoneKind::kTalus];
  limb_.surfaces.erase(BoneKind::kTalus);
  EXPECT_EQ(FindAnkle(limb_, femur_).center, ankle.center);
}

TEST_F(FindAnkleTest, FailsIfTheTalusLooksAtNothing) {
  limb_.surfaces[BoneKind::kTibia].points.col(2).array() += 30;
  const FoundJoint ankle = FindAnkle(limb_, femur_);
  EXPECT_EQ(ankle.verdict.quality, JointQuality::kFailed);
  EXPECT_THAT(ankle.verdict.reasons, ElementsAre(HasSubstr("within 6 mm")));
}

// A dome of 20 mm is flat for a person whose head of the femur has 15 mm.
TEST_F(FindAnkleTest, IsWeakIfTheDomeIsFlatForThePerson) {
  femur_ = SoundFemur();
  femur_.head->sphere.radius = 17;
  EXPECT_EQ(FindAnkle(limb_, femur_).verdict.quality, JointQuality::kGood);
  femur_.head->sphere.radius = 15;
  const FoundJoint ankle = FindAnkle(limb_, femur_);
  EXPECT_EQ(ankle.verdict.quality, JointQuality::kWeak);
  // Without a fibula nobody knows better: the inner malleolus is the higher.
  EXPECT_NEAR(HeightOf(ankle), 0, kHeight);
  EXPECT_THAT(ankle.verdict.reasons[0], ::testing::Not(HasSubstr("height of")));
}

TEST_F(FindAnkleTest, LiesBetweenTheTipsOfTheMalleoliWhereTheDomeIsWeak) {
  const double outer = inner_tip_ + 4;
  AddFibula(outer);
  const double middle = (inner_tip_ + outer) / 2;
  ASSERT_LT(std::abs(middle), 0.25 * 23);
  const FoundJoint good = FindAnkle(limb_, femur_);
  EXPECT_EQ(good.verdict.quality, JointQuality::kGood);
  EXPECT_NEAR(HeightOf(good), 0, kHeight);
  femur_ = SoundFemur();
  femur_.head->sphere.radius = 15;
  const FoundJoint weak = FindAnkle(limb_, femur_);
  EXPECT_EQ(weak.verdict.quality, JointQuality::kWeak);
  EXPECT_NEAR(HeightOf(weak), middle, kHeight);
  EXPECT_THAT(weak.verdict.reasons, ElementsAre(HasSubstr("height of the")));
}

// 0.25 radii of a head of 23 mm are 5.75 mm.
TEST_F(FindAnkleTest, IsWeakIfTheTipsAreFarFromTheAxis) {
  const auto with_middle_at = [&](double height) {
    AddFibula(2 * height - inner_tip_);
    return FindAnkle(limb_, femur_);
  };
  EXPECT_EQ(with_middle_at(-5).verdict.quality, JointQuality::kGood);
  const FoundJoint weak = with_middle_at(-6.5);
  EXPECT_EQ(weak.verdict.quality, JointQuality::kWeak);
  EXPECT_NEAR(HeightOf(weak), -6.5, kHeight);
}

// An outer tip more than 5 mm above the inner one is no tip: the fibula is cut.
TEST_F(FindAnkleTest, AsksForTheOuterTipOnlyIfItIsThere) {
  femur_ = SoundFemur();
  femur_.head->sphere.radius = 15;
  AddFibula(inner_tip_ + 4);
  EXPECT_NEAR(HeightOf(FindAnkle(limb_, femur_)), inner_tip_ + 2, kHeight);
  AddFibula(inner_tip_ + 6);
  EXPECT_NEAR(HeightOf(FindAnkle(limb_, femur_)), 0, kHeight);
}

// The outer side of a left leg is the left.
TEST_F(FindAnkleTest, ExchangesTheMalleoliOfALeftLeg) {
  femur_ = SoundFemur();
  femur_.head->sphere.radius = 15;
  limb_.side = Side::kLeft;
  // The fibula has the inner tip now, and the tibia one 8 mm above it.
  AddFibula(inner_tip_ - 8);
  EXPECT_NEAR(HeightOf(FindAnkle(limb_, femur_)), 0, kHeight);
  AddFibula(inner_tip_ - 2);
  EXPECT_NEAR(HeightOf(FindAnkle(limb_, femur_)), inner_tip_ - 1, kHeight);
}

// Where forward is decides which way the axis points.
TEST_F(FindAnkleTest, KnowsForwardByTheFemurTheFootAndTheImage) {
  const auto x_of_right = [&] {
    return FindAnkle(limb_, femur_).parent_axes(0, 2);
  };
  EXPECT_LT(x_of_right(), -0.9);
  limb_.surfaces[BoneKind::kFoot] =
      PointsBetween({0, 20, -60}, {0, 150, -60});  // backwards
  EXPECT_GT(x_of_right(), 0.9);
  // Before both, the femur.
  femur_ = SoundFemur();
  EXPECT_LT(x_of_right(), -0.9);
  femur_.directions->back *= -1;
  EXPECT_GT(x_of_right(), 0.9);
}

// A talus whose head is a ball of 12 mm before it, and whose facet is part of a
// hollow of 20 mm below it; navicular and heel bone are 3 mm away.
class FindSubtalarTest : public ::testing::Test {
 protected:
  FindSubtalarTest() {
    const Eigen::Vector3d forward(0, -1, 0), up(0, 0, 1);
    const auto head = [&](double radius) {
      return IdealCap({head_, radius}, forward, RadiansOf(60), 4000);
    };
    const auto facet = [&](double radius) {
      return IdealCap({facet_, radius}, up, RadiansOf(30), 8000);
    };
    SurfacePoints talus = Together(head(12), Hollow(facet(20)));
    const SurfacePoints top = PointsBetween({0, -25, 30}, {0, 10, 30});
    limb_.surfaces[BoneKind::kTalus] = Together(talus, top);
    limb_.surfaces[BoneKind::kFoot] = Together(Hollow(head(15)), facet(17));
    limb_.surfaces[BoneKind::kTibia] = PointsBetween({0, 0, 60}, {0, 0, 300});
  }

  void SetAreaOfFacet(double area) {
    SurfacePoints& talus = limb_.surfaces[BoneKind::kTalus];
    const int points =
        IdealCap({facet_, 20}, Eigen::Vector3d::UnitZ(), RadiansOf(30), 8000)
            .size();
    talus.area = area / points;
  }

  const Eigen::Vector3d head_{0, -40, 0}, facet_{0, 5, -25};
  Limb limb_;
};

TEST_F(FindSubtalarTest, IsTheLineThroughBothCentres) {
  SetAreaOfFacet(300);
  const FoundJoint joint = FindSubtalar(limb_, SoundFemur());
  EXPECT_EQ(joint.verdict.quality, JointQuality::kGood);
  EXPECT_LT((joint.center - (head_ + facet_) / 2).norm(), 1e-2);
  // From the heel to the head of the talus; the foot turns about x.
  EXPECT_LT((joint.parent_axes.col(0) - (head_ - facet_).normalized()).norm(),
            1e-3);
  EXPECT_GT(joint.parent_axes(2, 1), 0.8);
  ASSERT_EQ(joint.shapes.size(), 2u);
  EXPECT_TRUE(joint.shapes[0].is_on_parent && joint.shapes[1].is_on_parent);
  EXPECT_NEAR(joint.shapes[0].radius, 12, 0.01);
  EXPECT_NEAR(joint.shapes[1].radius, 20, 0.01);
}

TEST_F(FindSubtalarTest, IsWeakIfLittleOfTheFacetIsSeen) {
  SetAreaOfFacet(260);
  EXPECT_EQ(FindSubtalar(limb_, SoundFemur()).verdict.quality,
            JointQuality::kGood);
  SetAreaOfFacet(240);
  const FoundJoint joint = FindSubtalar(limb_, SoundFemur());
  EXPECT_EQ(joint.verdict.quality, JointQuality::kWeak);
  EXPECT_THAT(joint.verdict.reasons, ElementsAre(HasSubstr("only 240 mm2")));
}

// The centres are 51.5 mm apart: 1.4 heads of 36.8 mm.
TEST_F(FindSubtalarTest, IsWeakIfTheCentresAreNearForThePerson) {
  SetAreaOfFacet(300);
  FemurShape femur = SoundFemur();
  femur.head->sphere.radius = 35;
  EXPECT_EQ(FindSubtalar(limb_, femur).verdict.quality, JointQuality::kGood);
  femur.head->sphere.radius = 39;
  EXPECT_EQ(FindSubtalar(limb_, femur).verdict.quality, JointQuality::kWeak);
}

TEST_F(FindSubtalarTest, FailsWithoutTheBonesBelow) {
  limb_.surfaces[BoneKind::kFoot].points.col(2).array() -= 20;
  EXPECT_EQ(FindSubtalar(limb_, SoundFemur()).verdict.quality,
            JointQuality::kFailed);
  limb_.surfaces.erase(BoneKind::kFoot);
  const FoundJoint joint = FindSubtalar(limb_, SoundFemur());
  EXPECT_THAT(joint.verdict.reasons, ElementsAre(HasSubstr("no spheres")));
}

}  // namespace
}  // namespace musclewarp
