// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/knee_verdict.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "joints/hand_made_shapes.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// The verdict on the sound knee after a change of one measure.
JointVerdict JudgedWith(const std::function<void(FemurShape*)>& change) {
  FemurShape femur = SoundFemur();
  change(&femur);
  return JudgeKnee(femur);
}

Eigen::Vector3d LeftTurnedBy(double degrees) {
  return {std::cos(RadiansOf(degrees)), std::sin(RadiansOf(degrees)), 0};
}

TEST(JudgeKnee, HasNothingToSayOfASoundOne) {
  EXPECT_EQ(JudgeKnee(SoundFemur()).quality, JointQuality::kGood);
  EXPECT_THAT(JudgeKnee(SoundFemur()).reasons, IsEmpty());
}

TEST(JudgeKnee, FailsWithoutALowerEnd) {
  const JointVerdict shaft =
      JudgedWith([](auto* femur) { femur->directions->back_to_front = 1.1; });
  EXPECT_EQ(shaft.quality, JointQuality::kFailed);
  // 402 mm from a head of 23 mm.
  EXPECT_THAT(shaft.reasons,
              ElementsAre(HasSubstr("reaches back 1.1 times as far as forward "
                                    "(1.5 or more are needed) and is 17.5 "
                                    "radii of the head away from it (8")));
  const auto with_head_at = [](double height) {
    return JudgedWith([=](auto* femur) {
      femur->head->sphere.center = {0, 0, height};
    });
  };
  EXPECT_EQ(with_head_at(23 * 8.5).quality, JointQuality::kGood);
  EXPECT_EQ(with_head_at(23 * 7.5).quality, JointQuality::kFailed);
}

// Without a head nobody knows what a lower end is.
TEST(JudgeKnee, OfAPieceDoesNotAskForALowerEnd) {
  const JointVerdict piece = JudgedWith([](auto* femur) {
    femur->directions->back_to_front = 1.1;
    femur->head.reset();
  });
  EXPECT_EQ(piece.quality, JointQuality::kGood);
}

TEST(JudgeKnee, FailsIfTheAxisGoesAnotherWay) {
  const auto turned_by = [](double degrees) {
    return JudgedWith([=](auto* femur) {
      femur->knee->cylinder.axis.direction = LeftTurnedBy(degrees);
    });
  };
  EXPECT_EQ(turned_by(29).quality, JointQuality::kGood);
  EXPECT_EQ(turned_by(31).quality, JointQuality::kFailed);
  EXPECT_EQ(turned_by(180).quality, JointQuality::kGood);  // the same line
  EXPECT_EQ(turned_by(180 - 31).quality, JointQuality::kFailed);
}

// What spheres say of an axis means nothing if there are no condyles.
TEST(JudgeKnee, ComparesSpheresOnCondylesOnly) {
  const auto with_spheres = [](double degrees, double turn) {
    return JudgedWith([=](auto* femur) {
      femur->knee->sphere_angle = RadiansOf(degrees);
      femur->knee->cylinder.axis.direction = LeftTurnedBy(turn);
    });
  };
  EXPECT_EQ(with_spheres(4, 0).quality, JointQuality::kGood);
  EXPECT_EQ(with_spheres(8, 0).quality, JointQuality::kWeak);
  EXPECT_THAT(with_spheres(8, 0).reasons, ElementsAre(HasSubstr("is 8.0 deg")));
  EXPECT_EQ(with_spheres(25, 0).quality, JointQuality::kFailed);
  EXPECT_THAT(with_spheres(25, 40).reasons,
              ElementsAre(HasSubstr("is 40 degrees off the widest")));
}

TEST(JudgeKnee, LooksAtTheCondyleThatCoversLess) {
  for (const bool is_left : {true, false}) {
    const auto with_angle = [=](double degrees) {
      return JudgedWith([=](auto* femur) {
        KneeFit& knee = *femur->knee;
        (is_left ? knee.left_angle : knee.right_angle) = RadiansOf(degrees);
      });
    };
    EXPECT_EQ(with_angle(65).quality, JointQuality::kGood);
    EXPECT_EQ(with_angle(55).quality, JointQuality::kWeak);
    EXPECT_EQ(with_angle(25).quality, JointQuality::kFailed);
    EXPECT_THAT(with_angle(25).reasons, ElementsAre(HasSubstr("25 degrees")));
  }
}

TEST(JudgeKnee, IsWeakOnARoughSurfaceAndIfNothingTellsWhichEndIsUp) {
  EXPECT_EQ(JudgedWith([](auto* femur) { femur->knee->spread = 1.1; }).quality,
            JointQuality::kWeak);
  EXPECT_EQ(JudgedWith([](auto* femur) { femur->is_up_known = false; }).quality,
            JointQuality::kWeak);
}

}  // namespace
}  // namespace musclewarp
