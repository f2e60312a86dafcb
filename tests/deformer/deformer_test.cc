// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/deformer/deformer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "musclewarp/base/angles.h"
#include "musclewarp/base/input_error.h"
#include "musclewarp/musclewarp.h"
#include "support/small_scene.h"

namespace musclewarp {
namespace {

using ::testing::HasSubstr;

// A hull of few vertices: enough for laws, and quick.
DeformerOptions QuickOptions(ContactKind contact) {
  DeformerOptions options;
  options.frames.contact = contact;
  options.prepare.muscle.hull.coarse_vertices = 60;
  return options;
}

constexpr ContactKind kAllKinds[] = {
    ContactKind::kNone, ContactKind::kPaper, ContactKind::kCertified};

TEST(Deformer, DeformsASceneInMemoryWithEveryKindOfContact) {
  for (const ContactKind contact : kAllKinds) {
    Deformer deformer(SmallScene(), QuickOptions(contact));
    EXPECT_EQ(deformer.contact().kind, contact);
    const Frame frame = deformer.MoveTo(FlexedPose(0.1));
    EXPECT_TRUE(frame.IsUsable()) << frame.FullReport();
    ASSERT_EQ(frame.muscles.size(), 2u);
    EXPECT_EQ(frame.name, "flexed");
    EXPECT_EQ(frame.muscles[0].name, "left");
    // Both solvers keep the volume to 1e-8; contact on fine vertices, too.
    EXPECT_LT(frame.WorstVolumeError(), 2e-8);
    if (contact == ContactKind::kCertified) {
      EXPECT_TRUE(frame.intersections.IsClean());
    }
  }
}

TEST(Deformer, RestInRestOut) {
  for (const ContactKind contact :
       {ContactKind::kNone, ContactKind::kCertified}) {
    Deformer deformer(SmallScene(), QuickOptions(contact));
    const Frame frame = deformer.MoveTo(RestPose(SmallScene()));
    for (size_t i = 0; i < frame.muscles.size(); ++i) {
      // Nothing crosses at rest, and nothing is nearer than the gap.
      EXPECT_LT(
          (frame.muscles[i].points - deformer.RestFrame().muscles[i].points)
              .rowwise()
              .norm()
              .maxCoeff(),
          1e-6);
    }
  }
}

TEST(Deformer, AFrameOnItsOwnDoesNotDependOnWhereTheMusclesAre) {
  for (const ContactKind contact : kAllKinds) {
    Deformer deformer(SmallScene(), QuickOptions(contact));
    const Frame first = deformer.SolveAlone(FlexedPose(0.1));
    deformer.MoveTo(FlexedPose(-0.1));
    const Frame second = deformer.SolveAlone(FlexedPose(0.1));
    for (size_t i = 0; i < first.muscles.size(); ++i) {
      EXPECT_EQ(first.muscles[i].points, second.muscles[i].points);
    }
  }
}

TEST(Deformer, GoesOnFromAStateThatIsPutBack) {
  Deformer deformer(SmallScene(), QuickOptions(ContactKind::kCertified));
  deformer.MoveTo(FlexedPose(0.05));
  const SceneState state = deformer.state();
  const Frame first = deformer.MoveTo(FlexedPose(0.1));
  deformer.Reset();
  deformer.set_state(state);
  const Frame second = deformer.MoveTo(FlexedPose(0.1));
  for (size_t i = 0; i < first.muscles.size(); ++i) {
    EXPECT_EQ(first.muscles[i].points, second.muscles[i].points);
  }
}

TEST(Deformer, SeparatesMeshesThatOverlapAsDelivered) {
  Scene scene = SmallScene();
  scene.muscles[1].points.col(0).array() -= 3;  // 2 mm into the other
  Deformer deformer(scene, QuickOptions(ContactKind::kCertified));
  EXPECT_GT(deformer.RestFrame().intersections.triangle_pairs, 0);
  ASSERT_TRUE(deformer.contact().rest.has_value());
  EXPECT_TRUE(deformer.contact().rest->IsClean());
}

TEST(Deformer, TakesTheNameOfABoneForItsBody) {
  Deformer deformer(SmallScene(), QuickOptions(ContactKind::kNone));
  EXPECT_EQ(deformer.scene().scene.bones[1].body, "femur");
}

TEST(Deformer, RefusesASceneThatContradictsItself) {
  Scene scene = SmallScene();
  scene.muscles[1].name = "left";
  EXPECT_THROW(Deformer(scene, QuickOptions(ContactKind::kNone)), InputError);
  scene = SmallScene();
  scene.muscles[0].points.resize(0, 3);
  scene.muscles[0].triangles.resize(0, 3);
  EXPECT_THROW(Deformer(scene, QuickOptions(ContactKind::kNone)), InputError);
}

TEST(Deformer, RefusesAPoseThatContradictsTheScene) {
  Deformer deformer(SmallScene(), QuickOptions(ContactKind::kNone));
  ScenePose pose;
  pose.bodies["tibia"] = Eigen::Matrix4d::Identity();
  EXPECT_THROW(deformer.MoveTo(pose), InputError);
  EXPECT_THROW(deformer.SolveAlone(pose), InputError);
}

TEST(Deformer, CanBeStoppedAndLeavesTheStateAsItWas) {
  bool stops = false;
  DeformerOptions options = QuickOptions(ContactKind::kCertified);
  options.on_progress = [&](const Progress& progress) {
    if (stops && progress.stage == "moving" && progress.done > 0) {
      throw std::runtime_error("stopped");
    }
  };
  Deformer deformer(SmallScene(), options);
  const Frame expected = deformer.MoveTo(FlexedPose(0.02));
  const SceneState before = deformer.state();
  stops = true;
  EXPECT_THROW(deformer.MoveTo(FlexedPose(0.8)), std::runtime_error);
  EXPECT_EQ(deformer.state().pose.time, before.pose.time);
  EXPECT_EQ(deformer.state().contact->points, before.contact->points);
}

TEST(Deformer, ForetellsTheStepsToAPose) {
  const Deformer deformer(SmallScene(), QuickOptions(ContactKind::kCertified));
  const ScenePose rest = RestPose(SmallScene());
  // Short steps turn by 2.5 degrees; ends of lines, 55 mm away, move less than
  // 10 mm.
  EXPECT_EQ(deformer.ExpectedSteps(&rest, FlexedPose(RadiansOf(10.1))), 5);
  EXPECT_EQ(deformer.ExpectedSteps(nullptr, FlexedPose(RadiansOf(2.4))), 1);
}

TEST(DeformerOptions, CheckAllThatIsWithin) {
  DeformerOptions options;
  std::string error;
  EXPECT_TRUE(options.IsValid(&error));
  options.frames.certified.step.relaxation.max_push = -1;
  EXPECT_FALSE(options.IsValid(&error));
  EXPECT_THAT(error, HasSubstr("RelaxationOptions::max_push is -1"));
  options = {};
  options.frames.requirements.max_volume_error = -1;
  EXPECT_FALSE(options.IsValid(&error));
  options = {};
  options.solver.gauss_newton.max_iterations = 0;
  EXPECT_FALSE(options.IsValid(&error));
}

}  // namespace
}  // namespace musclewarp
