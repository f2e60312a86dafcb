// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "joints/made_leg.h"
#include "musclewarp/joints/articulation.h"
#include "musclewarp/joints/articulation_checks.h"
#include "support/input_errors.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

Bone BoneOf(const std::string& name,
            BoneKind kind,
            Side side,
            const TriangleSoup& mesh) {
  return {name, kind, side, "", mesh};
}

// Both arms: heads of the humeri on thin shafts, the left head of another size,
// scapulae beside them, and ulnae far away, whose elbows fail.
std::vector<Bone> BothArms(double size_of_left = 1) {
  std::vector<Bone> bones;
  for (const Side side : {Side::kRight, Side::kLeft}) {
    const bool is_right = side == Side::kRight;
    const double x = is_right ? -200 : 200;
    const double radius = is_right ? 22 : 22 * size_of_left;
    bones.push_back(BoneOf("scapula",
                           BoneKind::kScapula,
                           side,
                           MovedBy(Box(10, 10, 200), {0.7 * x, 0, -80})));
    bones.push_back(BoneOf("humerus",
                           BoneKind::kHumerus,
                           side,
                           Together(SphereAt({x, 0, 0}, radius, 3),
                                    MovedBy(Box(3, 3, 280), {x, 0, -165}))));
    bones.push_back(BoneOf(
        "ulna", BoneKind::kUlna, side, MovedBy(Box(3, 3, 250), {x, 0, -500})));
  }
  return bones;
}

const FoundJoint* JointNamed(const Articulation& found,
                             const std::string& name) {
  for (const FoundJoint& joint : found.joints) {
    if (joint.name() == name) return &joint;
  }
  return nullptr;
}

std::string CarrierOf(const Articulation& found, const std::string& body) {
  for (const Weld& weld : found.welds) {
    if (weld.child == body) return weld.parent;
  }
  return "";
}

const Articulation& FoundArms() {
  static const auto* found = new Articulation(Articulate(BothArms(), {}));
  return *found;
}

TEST(ArticulateBothSides, FindsJointsFromTheTrunkOutwards) {
  std::vector<std::string> names;
  for (const FoundJoint& joint : FoundArms().joints) {
    names.push_back(joint.name());
    EXPECT_EQ(joint.IsFound(), joint.kind == JointKind::kShoulder);
  }
  EXPECT_THAT(names,
              ElementsAre("shoulder_r", "elbow_r", "shoulder_l", "elbow_l"));
  EXPECT_EQ(JointNamed(FoundArms(), "shoulder_l")->parent, "scapula_l");
  EXPECT_EQ(JointNamed(FoundArms(), "shoulder_l")->child, "humerus_l");
}

// Bodies come after those that carry them: what has no joint is fixed to what
// would carry it.
TEST(ArticulateBothSides, ConnectsAllBodies) {
  const Articulation& found = FoundArms();
  EXPECT_EQ(found.bodies.size(), 6u);
  const auto place_of = [&](const std::string& body) {
    return std::find(found.bodies.begin(), found.bodies.end(), body);
  };
  for (const std::string suffix : {"_r", "_l"}) {
    EXPECT_LT(place_of("scapula" + suffix), place_of("humerus" + suffix));
    EXPECT_LT(place_of("humerus" + suffix), place_of("ulna" + suffix));
    EXPECT_EQ(CarrierOf(found, "scapula" + suffix), "ground");
    EXPECT_EQ(CarrierOf(found, "humerus" + suffix), "");
    EXPECT_EQ(CarrierOf(found, "ulna" + suffix), "humerus" + suffix);
  }
}

// Sides that differ by more than 10 % are both weak: 8 and 12 % here.
TEST(ArticulateBothSides, ComparesThem) {
  const auto reasons_with = [](double size_of_left) {
    std::vector<std::string> reasons;
    for (const FoundJoint& joint :
         Articulate(BothArms(size_of_left), {}).joints) {
      if (joint.kind != JointKind::kShoulder) continue;
      for (const std::string& reason : joint.verdict.reasons) {
        reasons.push_back(joint.name() + " " + reason);
      }
    }
    return reasons;
  };
  EXPECT_THAT(reasons_with(1 / 0.92), IsEmpty());
  EXPECT_THAT(
      reasons_with(0.88),
      UnorderedElementsAre(
          HasSubstr("shoulder_r the radii of the right and the left head of "
                    "the humerus differ: 21.9 and 19.3 mm"),
          HasSubstr("shoulder_l the radii")));
}

TEST(ArticulateBothSides, FindsOnlyWhatIsAskedFor) {
  ArticulationOptions options;
  options.side = Side::kLeft;
  options.joints = {JointKind::kShoulder};
  const Articulation found = Articulate(BothArms(), options);
  ASSERT_EQ(found.joints.size(), 1u);
  EXPECT_EQ(found.joints[0].name(), "shoulder_l");
  EXPECT_EQ(CarrierOf(found, "humerus_r"), "scapula_r");
  EXPECT_EQ(CarrierOf(found, "humerus_l"), "");
  EXPECT_EQ(found.bones[4].side, Side::kLeft);
}

TEST(ArticulateBodies, AreThoseThatTheUserNames) {
  std::vector<Bone> bones = BothArms();
  bones[1].body = "arm";
  const Articulation found = Articulate(bones, {});
  EXPECT_EQ(JointNamed(found, "shoulder_r")->child, "arm");
  EXPECT_EQ(JointNamed(found, "elbow_r")->parent, "arm");
  EXPECT_EQ(JointNamed(found, "shoulder_l")->child, "humerus_l");
  // One body has no joint inside.
  bones[2].body = "arm";
  const Articulation stiff = Articulate(bones, {});
  EXPECT_EQ(JointNamed(stiff, "elbow_r"), nullptr);
  EXPECT_NE(JointNamed(stiff, "elbow_l"), nullptr);
}

TEST(ArticulateBodies, ThatCarryEachOtherInACircleAreRefused) {
  std::vector<Bone> bones = BothArms();
  bones[2].body = "scapula_r";  // the ulna, which the humerus carries
  bones[0].body = "humerus_r";
  bones[1].body = "scapula_r";
  bones[3].body = "humerus_l";
  bones[4].body = "scapula_l";
  bones[5].body = "humerus_l";
  FoundJoint elbow;
  elbow.kind = JointKind::kElbow;
  ArticulationOptions options;
  elbow.side = Side::kLeft;
  options.given = {elbow};
  ExpectInputError([&] { Articulate(bones, options); },
                   {"carry each other in a circle"});
}

// Bones of no joint are fixed to the ground, a patella to the tibia, and a
// fibula is of the body of the tibia.
TEST(ArticulateBodies, WithoutJointsAreFixedToWhatTheyLieOn) {
  std::vector<Bone> bones = BothArms();
  const TriangleSoup shin = MovedBy(Box(20, 20, 300), {-100, 0, -1200});
  for (const auto& [name, kind] : {std::pair("tibia", BoneKind::kTibia),
                                   {"fibula", BoneKind::kFibula},
                                   {"patella", BoneKind::kPatella},
                                   {"sacrum", BoneKind::kSacrum}}) {
    bones.push_back(BoneOf(name, kind, Side::kRight, shin));
  }
  bones.push_back({"skull", BoneKind::kOther, {}, "", Box(9, 9, 9)});
  const Articulation found = Articulate(bones, {});
  EXPECT_EQ(CarrierOf(found, "patella_r"), "tibia_r");
  EXPECT_EQ(CarrierOf(found, "tibia_r"), "pelvis");
  EXPECT_EQ(CarrierOf(found, "pelvis"), "ground");
  EXPECT_EQ(CarrierOf(found, "skull"), "ground");
  EXPECT_EQ(found.bones[7].body, "tibia_r");
}

// A joint that is given is taken as it is, and compared with nothing.
TEST(ArticulateBodies, HaveJointsThatAreGiven) {
  FoundJoint given;
  given.kind = JointKind::kShoulder;
  given.side = Side::kLeft;
  given.center = {1, 2, 3};
  ArticulationOptions options;
  options.given = {given};
  const Articulation found = Articulate(BothArms(0.8), options);
  EXPECT_TRUE(JointNamed(found, "shoulder_l")->is_given);
  EXPECT_EQ(JointNamed(found, "shoulder_l")->center, given.center);
  EXPECT_FALSE(JointNamed(found, "shoulder_r")->is_given);
  EXPECT_THAT(JointNamed(found, "shoulder_r")->verdict.reasons, IsEmpty());
}

// As if the leg lay on its back, and coordinates zero in the pose of the scan.
TEST(ArticulateBodies, StandInTheirFrameOrItsAxesAreNotUsed) {
  ArticulationOptions options;
  options.axes = "LSP";
  options.zero = ZeroPose::kScan;
  const Articulation lying = Articulate(LegOf(Side::kRight).bones, options);
  EXPECT_THAT(lying.notes,
              ::testing::Contains(HasSubstr("do not stand in the frame")));
  for (const FoundJoint& joint : lying.joints) {
    EXPECT_EQ(joint.child_axes, joint.parent_axes);
  }
}

// No bone of an animal is longer than 10 m.
TEST(CheckBoneSize, RefusesTenMetres) {
  CheckBoneSize(BoneOf("ulna", BoneKind::kUlna, Side::kRight, Box(9990, 9, 9)));
  ExpectInputError(
      [] {
        CheckBoneSize(
            BoneOf("ulna", BoneKind::kUlna, Side::kRight, Box(10100, 9, 9)));
      },
      {"ulna", "is 10.1 m long"});
}

}  // namespace
}  // namespace musclewarp
