// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/skeleton_size.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "joints/made_leg.h"
#include "musclewarp/joints/articulation.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

using ::testing::HasSubstr;

// The made leg, enlarged to that of an adult, times a factor.
std::vector<Bone> ScaledLeg(double factor) {
  std::vector<Bone> bones = LegOf(Side::kRight).bones;
  for (Bone& bone : bones) bone.mesh.points *= 1.6 * factor;
  return bones;
}

TEST(SkeletonSize, IsOneForPeopleOfAnySizeAndForPartsOfBones) {
  for (const double factor : {0.4, 0.7, 1.0}) {
    EXPECT_EQ(SkeletonSizeOf(ScaledLeg(factor)), 1) << factor;
  }
  EXPECT_EQ(SkeletonSizeOf({}), 1);
}

TEST(SkeletonSize, IsThePowerOfTwoByWhichASkeletonIsLarger) {
  for (const double factor : {1.0 / 32, 1.0 / 4, 8.0}) {
    EXPECT_EQ(SkeletonSizeOf(ScaledLeg(factor)), factor);
  }
}

// By each kind of bone alone: the made boxes have the diagonal of an adult's.
TEST(SkeletonSize, IsThatOfAnyLongBone) {
  for (const auto& [kind, diagonal] : {std::pair(BoneKind::kFemur, 460.0),
                                       {BoneKind::kHumerus, 330.0},
                                       {BoneKind::kHipBone, 280.0},
                                       {BoneKind::kRadius, 250.0}}) {
    const auto size_with = [kind = kind](double length) {
      Bone bone;
      bone.kind = kind;
      bone.mesh = Box(
          length / std::sqrt(3), length / std::sqrt(3), length / std::sqrt(3));
      return SkeletonSizeOf({bone});
    };
    // From a newborn child to twice an adult nobody is scaled.
    EXPECT_EQ(size_with(0.31 * diagonal), 1);
    EXPECT_EQ(size_with(0.29 * diagonal), 0.25);
    EXPECT_EQ(size_with(1.99 * diagonal), 1);
    EXPECT_EQ(size_with(2.01 * diagonal), 2);
    EXPECT_EQ(size_with(diagonal / 63), 1.0 / 64);
    EXPECT_EQ(size_with(diagonal / 65), 1);
  }
}

// As a mesh in metres is that was taken for one in mm.
TEST(SkeletonSize, IsOneForWhatNoAnimalIsAsSmallAs) {
  EXPECT_EQ(SkeletonSizeOf(ScaledLeg(1e-3)), 1);
}

TEST(SkeletonSize, AScaledSkeletonHasTheScaledJointsToTheLastBit) {
  const Articulation human = Articulate(ScaledLeg(1), {});
  for (const double factor : {1.0 / 32, 8.0}) {
    const Articulation animal = Articulate(ScaledLeg(factor), {});
    ASSERT_EQ(animal.joints.size(), human.joints.size());
    for (size_t i = 0; i < human.joints.size(); ++i) {
      const FoundJoint& a = human.joints[i];
      const FoundJoint& b = animal.joints[i];
      EXPECT_EQ(factor * a.center, b.center);
      EXPECT_EQ(a.parent_axes, b.parent_axes);
      EXPECT_EQ(a.child_axes, b.child_axes);
      EXPECT_EQ(a.verdict.quality, b.verdict.quality);
      ASSERT_EQ(a.shapes.size(), b.shapes.size());
      for (size_t k = 0; k < a.shapes.size(); ++k) {
        EXPECT_EQ(factor * a.shapes[k].radius, b.shapes[k].radius);
      }
    }
    EXPECT_EQ(animal.bones[0].mesh.points, ScaledLeg(factor)[0].mesh.points);
    ASSERT_FALSE(animal.notes.empty());
    EXPECT_THAT(animal.notes.back(), HasSubstr("human size"));
  }
}

}  // namespace
}  // namespace musclewarp
