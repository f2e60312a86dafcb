// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/pelvis_frame.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "joints/made_leg.h"
#include "musclewarp/joints/articulation.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

// Hip bones as balls, 60 mm to the right and left of the middle, and the head
// of a femur 20 mm farther out.
TEST(PelvisFrame, TellsAWholePelvisFromOneHipBone) {
  const Points right = MovedBy(Icosphere(50, 3), {60, 0, 0}).points;
  const Points left = MovedBy(Icosphere(50, 3), {-60, 0, 0}).points;
  Points both(right.rows() + left.rows(), 3);
  both << right, left;
  const Sphere head = {{80, 0, -20}, 23};
  EXPECT_TRUE(IsOneHipBone(right, head));
  EXPECT_FALSE(IsOneHipBone(both, head));
  // At any size.
  EXPECT_TRUE(IsOneHipBone(right / 32, {head.center / 32, head.radius / 32}));
}

// One half, and its mirror image in the plane through its innermost point.
TEST(PelvisFrame, TheOtherHalfIsTheMirrorImageAtTheMiddle) {
  Points hip_bone(2, 3);
  hip_bone << 10, 1, 2, 60, 3, 4;  // x to the right
  const Eigen::Vector3d right = Eigen::Vector3d::UnitX();
  Points expected(4, 3);
  expected << hip_bone, 10, 1, 2, -40, 3, 4;
  EXPECT_EQ(WithMirrorImage(hip_bone, Side::kRight, right), expected);
  expected.bottomRows(2) << 110, 1, 2, 60, 3, 4;
  EXPECT_EQ(WithMirrorImage(hip_bone, Side::kLeft, right), expected);
}

// The made pelvis is a block about one head of a femur.
TEST(PelvisFrame, OneHipBoneThatIsCalledAPelvisIsTakenForWhatItIs) {
  const Articulation found = Articulate(LegOf(Side::kRight).bones, {});
  const auto pelvis =
      std::find_if(found.bones.begin(), found.bones.end(), [](auto& bone) {
        return bone.name == "pelvis";
      });
  EXPECT_EQ(pelvis->kind, BoneKind::kHipBone);
  EXPECT_EQ(pelvis->side, Side::kRight);
  EXPECT_TRUE(std::any_of(
      found.notes.begin(), found.notes.end(), [](const std::string& note) {
        return note.find("pelvis is taken for one hip bone") !=
               std::string::npos;
      }));
}

}  // namespace
}  // namespace musclewarp
