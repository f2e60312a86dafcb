// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/bone_sides.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "joints/hand_made_shapes.h"
#include "support/input_errors.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// A bone that is a single point: what lies nearest is then known.
SampledBone BoneAt(const std::string& name,
                   BoneKind kind,
                   const Eigen::Vector3d& place,
                   const std::optional<Side>& side = {}) {
  SampledBone bone;
  bone.bone.name = name;
  bone.bone.kind = kind;
  bone.bone.side = side;
  bone.surface = PointsBetween(place, place, 2);
  return bone;
}

SampledBone FemurAt(const std::optional<Side>& side = {}) {
  SampledBone femur = BoneAt("femur", BoneKind::kFemur, {0, 0, 0}, side);
  femur.femur = SoundFemur();
  return femur;
}

// The sound femur with its up and its back turned about an axis.
SampledBone FemurTurned(double degrees, const Eigen::Vector3d& about) {
  SampledBone femur = FemurAt();
  const Eigen::AngleAxisd turn(RadiansOf(degrees), about);
  BoneDirections& directions = *femur.femur.directions;
  directions.up = turn * directions.up;
  directions.back = turn * directions.back;
  return femur;
}

std::optional<Side> SideAfter(const SampledBone& bone,
                              std::vector<SampledBone> others,
                              bool has_axes = true) {
  others.push_back(bone);
  std::vector<std::string> notes;
  std::optional<Eigen::Matrix3d> axes;
  if (has_axes) axes = AxesOfLps();
  DecideSides({}, axes, &others, &notes);
  return others.back().bone.side;
}

TEST(HasSide, IsTrueOfBonesThatThereAreTwoOf) {
  for (const BoneKind kind :
       {BoneKind::kPelvis, BoneKind::kSacrum, BoneKind::kOther}) {
    EXPECT_FALSE(HasSide(kind));
  }
  for (const BoneKind kind :
       {BoneKind::kHipBone, BoneKind::kFemur, BoneKind::kRadius}) {
    EXPECT_TRUE(HasSide(kind));
  }
}

// A femur that leans more than 45 degrees does not stand in that frame.
TEST(AgreeWithImage, TheFemoraWithinHalfARightAngle) {
  const Eigen::Vector3d forward(0, -1, 0), up(0, 0, 1);
  for (const double sign : {-1.0, 1.0}) {
    for (const Eigen::Vector3d& about : {forward, up}) {
      EXPECT_TRUE(AgreeWithImage({FemurTurned(sign * 44, about)}, AxesOfLps()));
      EXPECT_FALSE(
          AgreeWithImage({FemurTurned(sign * 46, about)}, AxesOfLps()));
    }
  }
  EXPECT_FALSE(AgreeWithImage({FemurAt(), FemurTurned(180, up)}, AxesOfLps()));
  // Of a femur without a head nobody knows how it stands.
  SampledBone piece = FemurTurned(180, up);
  piece.femur.head.reset();
  EXPECT_TRUE(AgreeWithImage({piece}, AxesOfLps()));
}

TEST(DecideSides, AFemurHasTheSideOfItsShape) {
  std::vector<SampledBone> bones = {FemurAt()};
  std::vector<std::string> notes;
  EXPECT_TRUE(DecideSides({}, {}, &bones, &notes));
  EXPECT_EQ(bones[0].bone.side, Side::kRight);
  EXPECT_THAT(notes, ElementsAre("femur: a right femur, by its shape"));
  bones = {FemurAt()};
  bones[0].femur.head->sphere.center.x() *= -1;
  EXPECT_TRUE(DecideSides({}, {}, &bones, &notes));
  EXPECT_EQ(bones[0].bone.side, Side::kLeft);
  // A name that agrees is nothing to be noted.
  bones = {FemurAt(Side::kRight)};
  notes.clear();
  EXPECT_TRUE(DecideSides({}, {}, &bones, &notes));
  EXPECT_THAT(notes, IsEmpty());
}

TEST(DecideSides, RefuseAFemurOfTheOtherSide) {
  std::vector<std::string> notes;
  std::vector<SampledBone> bones = {FemurAt(Side::kLeft)};
  ExpectInputError([&] { DecideSides({}, {}, &bones, &notes); },
                   {"has the shape of a right femur and is named left"});
  // x is to the left, and the head at 40.
  const auto decide_beside_sacrum_at = [&](double x) {
    bones = {FemurAt(), BoneAt("sacrum", BoneKind::kSacrum, {x, 0, 400})};
    return DecideSides({}, AxesOfLps(), &bones, &notes);
  };
  ExpectInputError([&] { decide_beside_sacrum_at(29); },
                   {"right femur and lies on the left of the pelvis"});
  EXPECT_TRUE(decide_beside_sacrum_at(31));
  EXPECT_TRUE(decide_beside_sacrum_at(60));
}

TEST(DecideSides, BonesHaveTheSideThatIsSaid) {
  std::vector<SampledBone> bones = {
      BoneAt("tibia", BoneKind::kTibia, {0, 0, 0}),
      BoneAt("sacrum", BoneKind::kSacrum, {0, 0, 0}),
      BoneAt("ulna", BoneKind::kUlna, {0, 0, 0}, Side::kRight)};
  std::vector<std::string> notes;
  EXPECT_TRUE(DecideSides(Side::kLeft, {}, &bones, &notes));
  EXPECT_EQ(bones[0].bone.side, Side::kLeft);
  EXPECT_FALSE(bones[1].bone.side);
  EXPECT_EQ(bones[2].bone.side, Side::kRight);
  EXPECT_THAT(notes, IsEmpty());
}

// Bones of one limb are nearer to each other than 60 mm.
TEST(DecideSides, BonesHaveTheSideOfTheNearestWithinSixtyMillimetres) {
  const auto side_at = [](double distance) {
    return SideAfter(BoneAt("tibia", BoneKind::kTibia, {distance, 0, 0}),
                     {FemurAt()},
                     /*has_axes=*/false);
  };
  EXPECT_EQ(side_at(59), Side::kRight);
  EXPECT_FALSE(side_at(61));
  const SampledBone left =
      BoneAt("tibia", BoneKind::kTibia, {50, 0, 0}, Side::kLeft);
  const auto between_at = [&](double x) {
    return SideAfter(BoneAt("patella", BoneKind::kPatella, {x, 0, 0}),
                     {left, FemurAt()});
  };
  EXPECT_EQ(between_at(24), Side::kRight);
  EXPECT_EQ(between_at(26), Side::kLeft);
}

// The nearest of all first: the foot hangs on the tibia, which hangs on the
// femur, and a left bone lies nearer to the foot than the femur does.
TEST(DecideSides, SpreadAlongALimb) {
  std::vector<SampledBone> bones = {
      BoneAt("foot", BoneKind::kFoot, {90, 0, 0}),
      BoneAt("tibia", BoneKind::kTibia, {45, 0, 0}),
      FemurAt(),
      BoneAt("ulna", BoneKind::kUlna, {90, 50, 0}, Side::kLeft)};
  std::vector<std::string> notes;
  EXPECT_TRUE(DecideSides({}, {}, &bones, &notes));
  EXPECT_EQ(bones[1].bone.side, Side::kRight);
  EXPECT_EQ(bones[0].bone.side, Side::kRight);
  ASSERT_EQ(notes.size(), 2u);
  EXPECT_THAT(notes[1], HasSubstr("tibia (right), foot (right)"));
}

// The middle of the body is not exact: within 10 mm of it a bone has no side.
TEST(DecideSides, ByThePlaceInTheImage) {
  const SampledBone sacrum = BoneAt("sacrum", BoneKind::kSacrum, {5, 100, 900});
  const auto side_at = [&](double x, bool has_axes) {
    return SideAfter(
        BoneAt("tibia", BoneKind::kTibia, {x, 0, 0}), {sacrum}, has_axes);
  };
  EXPECT_EQ(side_at(5 + 11, true), Side::kLeft);
  EXPECT_EQ(side_at(5 - 11, true), Side::kRight);
  EXPECT_FALSE(side_at(5 + 9, true));
  EXPECT_FALSE(side_at(5 - 9, true));
  EXPECT_FALSE(side_at(5 + 11, false));
  std::vector<SampledBone> bones = {
      BoneAt("tibia", BoneKind::kTibia, {99, 0, 0}), sacrum};
  std::vector<std::string> notes;
  EXPECT_TRUE(DecideSides({}, AxesOfLps(), &bones, &notes));
  EXPECT_THAT(notes, ElementsAre("tibia: left, by its place in the image"));
}

// The sacrum has the middle of the body, then halves of a pelvis, and of hip
// bones both.
TEST(DecideSides, TheMiddleIsThatOfWhatLiesInTheMiddle) {
  const auto hip_bone = [](double x) {
    return BoneAt("hip", BoneKind::kHipBone, {x, 0, 900}, Side::kLeft);
  };
  const auto pelvis = [](double x) {
    return BoneAt("pelvis", BoneKind::kPelvis, {x, 0, 900});
  };
  const SampledBone sacrum = BoneAt("sacrum", BoneKind::kSacrum, {80, 0, 900});
  const SampledBone tibia = BoneAt("tibia", BoneKind::kTibia, {40, 0, 0});
  EXPECT_FALSE(SideAfter(tibia, {hip_bone(0)}));
  EXPECT_EQ(SideAfter(tibia, {hip_bone(-30), hip_bone(70)}), Side::kLeft);
  EXPECT_EQ(SideAfter(tibia, {hip_bone(70), hip_bone(50)}), Side::kRight);
  EXPECT_EQ(SideAfter(tibia, {pelvis(0), pelvis(20), hip_bone(70)}),
            Side::kLeft);
  EXPECT_EQ(SideAfter(tibia, {pelvis(0), sacrum}), Side::kRight);
}

TEST(DecideSides, BonesWithoutOneAreOfNoJoint) {
  std::vector<SampledBone> bones = {
      BoneAt("tibia", BoneKind::kTibia, {0, 0, 0}),
      FemurAt(),
      BoneAt("pelvis", BoneKind::kPelvis, {0, 0, 500})};
  bones[1].bone.name = "piece";
  bones[1].femur.head.reset();
  bones.push_back({});
  bones.back().bone.name = "ulna";
  bones.back().bone.kind = BoneKind::kUlna;
  std::vector<std::string> notes;
  EXPECT_FALSE(DecideSides({}, {}, &bones, &notes));
  EXPECT_EQ(bones[0].bone.kind, BoneKind::kOther);
  EXPECT_EQ(bones[1].bone.kind, BoneKind::kOther);
  EXPECT_EQ(bones[2].bone.kind, BoneKind::kPelvis);
  EXPECT_EQ(bones[3].bone.kind, BoneKind::kOther);
  EXPECT_THAT(notes,
              ElementsAre(HasSubstr("tibia: of no joint"),
                          HasSubstr("piece: of no joint"),
                          HasSubstr("ulna: of no joint")));
}

}  // namespace
}  // namespace musclewarp
