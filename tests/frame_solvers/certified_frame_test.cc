// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frame_solvers/certified_frame.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

#include "support/meshes.h"
#include "support/prepared_small_scene.h"

namespace musclewarp {
namespace {

using ::testing::IsEmpty;

// The small scene with a third bone, which lies in the pelvis. Both muscles, 25
// mm apart and 24 mm thick, are attached to pelvis and femur.
struct SeparatedScene {
  PreparedScene scene;
  std::unique_ptr<SceneMeshes> meshes;
  CertifiedScene certified;

  SeparatedScene() {
    Scene raw = SmallScene();
    const TriangleSoup sacrum = MovedBy(Icosphere(10, 2), {0, 0, -85});
    raw.bones.push_back({"sacrum", sacrum.points, sacrum.triangles});
    scene = PreparedSmallScene(raw);
    meshes = std::make_unique<SceneMeshes>(scene);
    certified = PrepareCertifiedScene(
        scene, *meshes, {}, {}, ReferenceSolvers().single, {});
  }

  // The frame of a state in the rest pose.
  Frame FrameOf(const ContactState& state,
                const FrameRequirements& requirements = {}) {
    return CertifiedFrame(scene,
                          certified,
                          requirements,
                          state,
                          {},
                          std::vector<SolverSummary>(scene.muscles.size()),
                          meshes.get());
  }

  // The place of a muscle of the scene in the order of contact.
  size_t PlaceOf(int muscle) const {
    size_t k = 0;
    while (certified.order[k] != muscle) ++k;
    return k;
  }
};

SeparatedScene& Separated() {
  static auto* separated = new SeparatedScene();
  return *separated;
}

// The rest pose, with the bones of a muscle moved aside from what it is
// attached to.
Frame WithDrift(double drift) {
  ContactState state = Separated().certified.rest;
  state.held[Separated().PlaceOf(1)].positions.col(1).array() += drift;
  FrameRequirements requirements;
  requirements.displacement_allowance = 10;  // contact holds the muscle back
  return Separated().FrameOf(state, requirements);
}

// Where both muscles are without contact if one of them comes nearer, and with
// contact.
Frame WithOverlap(double way, const FrameRequirements& requirements) {
  ContactState state = Separated().certified.rest;
  const size_t k = Separated().PlaceOf(1);
  state.free_coarse[k].col(0).array() -= way;
  state.held[k].positions.col(0).array() -= way;
  return Separated().FrameOf(state, requirements);
}

// Rounding of positions of 100 mm, and of what is solved to 1e-9.
constexpr double kRoundingOfFrames = 1e-6;  // mm

TEST(CertifiedFrame, MeasuresHowFarAMuscleLeavesItsBones) {
  const Frame frame = WithDrift(1.5);
  for (const AttachmentDrift& drift : frame.muscles[1].attachments) {
    EXPECT_NEAR(drift.max, 1.5, kRoundingOfFrames);
  }
  for (const AttachmentDrift& drift : frame.muscles[0].attachments) {
    EXPECT_LT(drift.max, kRoundingOfFrames);
  }
}

// Bones that lie in each other are the likely cause, and otherwise nobody's
// business. An attachment may drift by 2 mm.
TEST(CertifiedFrame, LooksAtBonesIfAMuscleLeavesThem) {
  const Frame near = WithDrift(1.9);
  EXPECT_THAT(near.shortcomings, IsEmpty()) << near.FullReport();
  EXPECT_THAT(near.bone_overlaps, IsEmpty());
  const Frame far = WithDrift(2.1);
  EXPECT_THAT(far.shortcomings, IsEmpty()) << far.FullReport();
  ASSERT_EQ(far.bone_overlaps.size(), 1u);
}

TEST(CertifiedFrame, LooksAtBonesIfTheFrameHasShortcomings) {
  FrameRequirements requirements;
  const Frame sound =
      Separated().FrameOf(Separated().certified.rest, requirements);
  EXPECT_THAT(sound.shortcomings, IsEmpty()) << sound.FullReport();
  EXPECT_THAT(sound.bone_overlaps, IsEmpty());
  requirements.gap = 1.9;  // muscles are about 1 mm apart
  const Frame judged =
      Separated().FrameOf(Separated().certified.rest, requirements);
  EXPECT_FALSE(judged.shortcomings.empty());
  EXPECT_EQ(judged.bone_overlaps.size(), 1u);
}

// Both muscles are 1 mm apart. If one comes 4 mm nearer, both are 3 mm deep in
// each other, and contact has moved that one by 4 mm.
TEST(CertifiedFrame, MeasuresWhatContactDoes) {
  FrameRequirements requirements;
  requirements.displacement_allowance = 10;
  const Frame frame = WithOverlap(4, requirements);
  // The rest pose has been solved for, which moves muscles by some tenths.
  constexpr double kSettled = 0.4;  // mm
  EXPECT_NEAR(frame.muscles[1].max_contact_displacement, 4, kSettled);
  EXPECT_LT(frame.muscles[0].max_contact_displacement, kSettled);
  EXPECT_LE(frame.muscles[1].mean_contact_displacement,
            frame.muscles[1].max_contact_displacement);
  EXPECT_GT(frame.muscles[1].mean_contact_displacement, 3);
  for (const MuscleFrame& muscle : frame.muscles) {
    EXPECT_NEAR(muscle.depth_without_contact, 3, kSettled);
    EXPECT_NEAR(
        muscle.push_depth, muscle.depth_without_contact, kRoundingOfFrames);
  }
  // Nothing is where contact put it if nothing comes nearer.
  const Frame rest = Separated().FrameOf(Separated().certified.rest);
  EXPECT_EQ(rest.muscles[1].depth_without_contact, 0);
  EXPECT_LT(rest.muscles[1].max_contact_displacement, kSettled);
}

// Twice the depth without contact, and 1 mm.
TEST(CertifiedFrame, AllowsContactToMoveWhatIsInTheWay) {
  FrameRequirements requirements;
  EXPECT_THAT(WithOverlap(4, requirements).shortcomings, IsEmpty());
  requirements.displacement_per_depth = 0.5;
  EXPECT_EQ(WithOverlap(4, requirements).shortcomings.size(), 1u);
}

// The gap that contact keeps is required, whatever the requirements have.
TEST(CertifiedFrame, RequiresTheGapOfContact) {
  SeparatedScene& separated = Separated();
  const double kept = separated.certified.options.step.gap;
  separated.certified.options.step.gap = 1.9;
  const Frame frame = separated.FrameOf(separated.certified.rest);
  separated.certified.options.step.gap = kept;
  EXPECT_FALSE(frame.shortcomings.empty());
}

// The displacement of the rest pose by contact is judged by the same
// requirements: the muscle that has been moved farther is told.
TEST(RestResultOf, TellsTheMusclesThatContactMovedTooFar) {
  SeparatedScene& separated = Separated();
  CertifiedScene certified = separated.certified;
  const size_t k = separated.PlaceOf(1);
  certified.rest.free_coarse[k].col(1).array() += 4;
  certified.rest.held[k].positions.col(1).array() += 4;
  const auto displaced_by = [&](double allowance) {
    FrameRequirements requirements;
    requirements.displacement_allowance = allowance;
    return RestResultOf(
               separated.scene, certified, requirements, separated.meshes.get())
        .displaced;
  };
  EXPECT_EQ(displaced_by(3.4), std::vector<int>{1});
  EXPECT_THAT(displaced_by(4.6), IsEmpty());
}

TEST(RestResultOf, HasTheRestPoseAndWhatCrossesInIt) {
  SeparatedScene& separated = Separated();
  const RestResult rest = RestResultOf(
      separated.scene, separated.certified, {}, separated.meshes.get());
  EXPECT_TRUE(rest.intersections.IsClean());
  EXPECT_EQ(rest.state.points[0], separated.certified.rest.points[0]);
}

}  // namespace
}  // namespace musclewarp
