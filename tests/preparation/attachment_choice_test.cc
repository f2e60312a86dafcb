// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/attachment_choice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "musclewarp/preparation/surroundings.h"
#include "support/meshes.h"
#include "support/small_scene.h"

namespace musclewarp {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<FoundAttachment> FoundOn(const SceneMuscle& muscle,
                                     const Surroundings& surroundings) {
  return FindAttachments(
      {muscle.points, muscle.triangles}, surroundings.bodies(), muscle.lines);
}

class ChooseAttachmentsTest : public ::testing::Test {
 protected:
  ChooseAttachmentsTest() {
    for (const SceneBone& bone : scene_.bones) {
      surroundings_.AddBone(
          bone.name, bone.name, {bone.points, bone.triangles});
    }
    for (const SceneMuscle& muscle : scene_.muscles) {
      surroundings_.AddMuscle({muscle.points, muscle.triangles});
    }
  }

  std::vector<Attachment> Choose(AttachmentKind kind) {
    const SceneMuscle& muscle = scene_.muscles[0];
    return ChooseAttachments(kind,
                             muscle,
                             poses_,
                             {muscle.points, muscle.triangles},
                             FoundOn(muscle, surroundings_),
                             surroundings_.bodies(),
                             surroundings_.MusclesBeside(0),
                             /*body_size=*/1,
                             &warnings_);
  }

  void NameAnAttachment() {
    Attachment named;
    named.body = "femur";
    named.points = Eigen::RowVector3d(-12.5, 0, 55);
    named.radius = 4;
    scene_.muscles[0].attachments = {named};
  }

  // Poses in which the upper end of the line leaves the femur by 9 mm.
  void LetTheLineLeave() {
    ScenePose pose = FlexedPose(0);
    const ActionLine& line = scene_.muscles[0].lines[0];
    pose.lines[line.name] = line.rest;
    pose.lines[line.name](2, 1) += 9;
    poses_ = {pose};
  }

  Scene scene_ = SmallScene();
  std::vector<ScenePose> poses_ = {FlexedPose(0.3)};
  Surroundings surroundings_;
  std::vector<std::string> warnings_;
};

TEST_F(ChooseAttachmentsTest, FindsThemOnlyWhereTheSceneNamesNone) {
  const auto found = Choose(AttachmentKind::kAuto);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].body, "pelvis");
  EXPECT_EQ(found[1].body, "femur");
  EXPECT_THAT(Choose(AttachmentKind::kScene), IsEmpty());
  EXPECT_THAT(Choose(AttachmentKind::kNone), IsEmpty());
  NameAnAttachment();
  const auto named = Choose(AttachmentKind::kAuto);
  ASSERT_EQ(named.size(), 1u);
  EXPECT_EQ(named[0].radius, 4);
  EXPECT_THAT(warnings_, IsEmpty());
}

TEST_F(ChooseAttachmentsTest, DropsAFoundOneThatTheLineLeaves) {
  LetTheLineLeave();
  const auto found = Choose(AttachmentKind::kAuto);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].body, "pelvis");
  EXPECT_THAT(warnings_,
              ElementsAre(AllOf(HasSubstr("line left_line of muscle left"),
                                HasSubstr("leaves femur"),
                                HasSubstr("by 9 mm in pose flexed"),
                                HasSubstr("follows the line"))));
}

TEST_F(ChooseAttachmentsTest, KeepsANamedOneThatTheLineLeavesAndWarns) {
  LetTheLineLeave();
  NameAnAttachment();
  EXPECT_EQ(Choose(AttachmentKind::kAuto).size(), 1u);
  EXPECT_THAT(warnings_, ElementsAre(HasSubstr("leaves femur")));
}

// A muscle whose lower tip, at z = 0, has no bone.
class TipWithoutBoneTest : public ::testing::Test {
 protected:
  TipWithoutBoneTest() {
    const TriangleSoup bone = SphereAt({0, 0, 107}, 8, 2);
    surroundings_.AddBone("femur", "femur", bone);
    surroundings_.AddMuscle({muscle_.points, muscle_.triangles});
  }

  size_t NumHeld() {
    std::vector<std::string> warnings;
    return ChooseAttachments(AttachmentKind::kAuto,
                             muscle_,
                             {},
                             {muscle_.points, muscle_.triangles},
                             FoundOn(muscle_, surroundings_),
                             surroundings_.bodies(),
                             surroundings_.MusclesBeside(0),
                             /*body_size=*/1,
                             &warnings)
        .size();
  }

  void AddLineTo(double lower) {
    ActionLine line;
    line.rest.resize(2, 3);
    line.rest << 0, 0, 100, 0, 0, lower;
    muscle_.lines = {line};
  }

  SceneMuscle muscle_ = [] {
    const TriangleSoup mesh = MovedBy(Spindle(10, 50, 4), {0, 0, 50});
    return SceneMuscle{"muscle", mesh.points, mesh.triangles};
  }();
  Surroundings surroundings_;
};

TEST_F(TipWithoutBoneTest, IsHeldByTheNearestBody) { EXPECT_EQ(NumHeld(), 2u); }

TEST_F(TipWithoutBoneTest, IsNotHeldOnAnotherSoftPart) {
  surroundings_.AddMuscle(SphereAt({0, 0, -8}, 20, 3));
  EXPECT_EQ(NumHeld(), 1u);
}

TEST_F(TipWithoutBoneTest, IsNotHeldWhereALineGoesOn) {
  AddLineTo(-60);
  EXPECT_EQ(NumHeld(), 1u);
}

// Even on a bone: the muscle does not end beside its tendon.
TEST_F(TipWithoutBoneTest, IsNotHeldWhereATendonHasNoMesh) {
  const TriangleSoup bone = SphereAt({0, 0, -11}, 10, 3);
  surroundings_.AddBone("tibia", "tibia", bone);
  AddLineTo(-8);
  EXPECT_EQ(NumHeld(), 2u);
  muscle_.lines[0].bare_end = 8;
  EXPECT_EQ(NumHeld(), 1u);
}

TEST_F(TipWithoutBoneTest, IsHeldWhereALineEndsSomewhatBeyond) {
  AddLineTo(-8);
  EXPECT_EQ(NumHeld(), 2u);
}

TEST(Surroundings, JoinTheBonesOfABody) {
  const Scene scene = SmallScene();
  Surroundings surroundings;
  for (const char* body : {"pelvis", "femur", "pelvis"}) {
    surroundings.AddBone(
        body, body, {scene.bones[0].points, scene.bones[0].triangles});
  }
  ASSERT_EQ(surroundings.bodies().size(), 2u);
  EXPECT_EQ(surroundings.bodies()[0].body, "pelvis");
  EXPECT_EQ(surroundings.bodies()[0].bones.size(), 2u);
  EXPECT_EQ(surroundings.bodies()[1].bones.size(), 1u);
}

}  // namespace
}  // namespace musclewarp
