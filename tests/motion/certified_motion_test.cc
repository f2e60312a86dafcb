// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/certified_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cereal/archives/binary.hpp>
#include <sstream>
#include <string>

#include "musclewarp/base/angles.h"
#include "musclewarp/frames/frame_measures.h"
#include "musclewarp/motion/state_archive.h"
#include "support/meshes.h"
#include "support/prepared_small_scene.h"

namespace musclewarp {
namespace {

CertifiedScene Certified(const PreparedScene& scene,
                         const CertifiedContactOptions& options = {}) {
  const SceneMeshes meshes(scene);
  return PrepareCertifiedScene(
      scene, meshes, options, {}, ReferenceSolvers().single, {});
}

CertifiedMotion Move(const PreparedScene& scene,
                     const CertifiedScene& certified,
                     const ScenePose& pose,
                     const ContactState& before) {
  return MoveCertified(scene,
                       certified,
                       pose,
                       {},
                       ReferenceSolvers().single,
                       before,
                       Settling::kIfPushed,
                       {});
}

TEST(PrepareCertifiedScene, LeavesARestPoseInWhichNothingIsNear) {
  const PreparedScene scene = PreparedSmallScene();
  const CertifiedScene certified = Certified(scene);
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_LT(
        (certified.rest.points[i] - scene.muscles[i].model.fine_rest).norm(),
        1e-6);
  }
}

TEST(PrepareCertifiedScene, TakesMusclesInTheOrderOfTheirNames) {
  Scene scene = SmallScene();
  scene.muscles[0].name = "z_left";
  const CertifiedScene certified = Certified(PreparedSmallScene(scene));
  EXPECT_EQ(certified.order, (std::vector<int>{1, 0}));
}

TEST(MoveCertified, ReachesAPoseWithoutCrossings) {
  const PreparedScene scene = PreparedSmallScene();
  const CertifiedScene certified = Certified(scene);
  SceneMeshes meshes(scene);
  const CertifiedMotion motion =
      Move(scene, certified, FlexedPose(0.3), certified.rest);
  EXPECT_EQ(motion.state.pose.name, "flexed");
  ASSERT_EQ(motion.summary.summaries.size(), 2u);
  const Frame frame = MeasureFrame(scene,
                                   motion.state.pose,
                                   ShapesOf(certified, motion.state),
                                   {},
                                   motion.summary.summaries,
                                   &meshes);
  EXPECT_TRUE(frame.intersections.IsClean());
  EXPECT_LT(frame.WorstVolumeError(), 2e-8);
}

// The largest difference of the fine meshes of two states, mm.
double LargestDifference(const ContactState& a, const ContactState& b) {
  double largest = 0;
  for (size_t i = 0; i < a.points.size(); ++i) {
    largest =
        std::max(largest, (a.points[i] - b.points[i]).cwiseAbs().maxCoeff());
  }
  return largest;
}

// Returns whether nothing crosses in a state.
bool IsClean(const PreparedScene& scene,
             const CertifiedScene& certified,
             const ContactState& state) {
  SceneMeshes meshes(scene);
  return MeasureFrame(scene,
                      state.pose,
                      ShapesOf(certified, state),
                      {},
                      {{}, {}},
                      &meshes)
      .intersections.IsClean();
}

// The bone jumps into the muscles.
ScenePose IntoTheMuscles() {
  ScenePose pose;
  pose.name = "into the muscles";
  Eigen::Matrix4d jump = Eigen::Matrix4d::Identity();
  jump(2, 3) = -60;
  pose.bodies["femur"] = jump;
  return pose;
}

TEST(MoveCertified, GoesOnFromTheLastCleanStateAfterAFailure) {
  const PreparedScene scene = PreparedSmallScene();
  CertifiedContactOptions options;
  // One step for the whole way, with nothing done against crossings.
  options.limits = {M_PI, 1000};
  options.max_halvings = 0;
  options.max_returns = 0;
  options.step.max_rounds = 1;
  const CertifiedScene certified = Certified(scene, options);
  const CertifiedMotion failed =
      Move(scene, certified, IntoTheMuscles(), certified.rest);
  ASSERT_FALSE(IsClean(scene, certified, failed.state));
  ASSERT_TRUE(failed.last_clean.has_value());
  EXPECT_EQ(failed.state.pose.name, "into the muscles");
  EXPECT_TRUE(IsClean(scene, certified, *failed.last_clean));
  // It may have settled in its own pose, where it was at rest but for rounding.
  EXPECT_LT(LargestDifference(*failed.last_clean, certified.rest), 1e-9);
  const CertifiedMotion back =
      Move(scene, certified, FlexedPose(0.05), *failed.last_clean);
  EXPECT_TRUE(IsClean(scene, certified, back.state));
}

TEST(MoveCertified, GoesBackForShorterStepsWhereItIsStuck) {
  const PreparedScene scene = PreparedSmallScene();
  CertifiedContactOptions options;
  // One step for the whole way, with nothing done against crossings.
  options.limits = {M_PI, 1000};
  options.unchecked_fraction = 1;
  options.step.max_rounds = 1;
  options.max_reach = options.step.reach;
  options.max_halvings = 0;
  options.max_returns = 0;
  ScenePose pose = IntoTheMuscles();
  pose.bodies["femur"](2, 3) = -45;
  CertifiedScene certified = Certified(scene, options);
  const CertifiedMotion stuck = Move(scene, certified, pose, certified.rest);
  EXPECT_FALSE(IsClean(scene, certified, stuck.state));
  certified.options.max_returns = 1;
  const CertifiedMotion back = Move(scene, certified, pose, certified.rest);
  EXPECT_TRUE(IsClean(scene, certified, back.state));
  // Four steps more, and those that settle.
  EXPECT_GE(back.summary.steps, 5);
}

// The bone jumps into the muscles, and as far again.
ScenePose ThroughTheMuscles() {
  ScenePose pose = IntoTheMuscles();
  pose.bodies["femur"](2, 3) *= 2;
  return pose;
}

// Two steps for that way, with nothing done against crossings, and a single one
// allowed to leave some.
CertifiedContactOptions StuckAtOnce() {
  CertifiedContactOptions options;
  options.limits = {M_PI, 60};
  options.unchecked_fraction = 1;
  options.max_halvings = 0;
  options.max_returns = 0;
  options.max_reach = options.step.reach;
  options.step.max_rounds = 1;
  options.max_stuck_steps = 1;
  return options;
}

TEST(MoveCertified, GoesTheRestOfTheWayWithoutContactWhereItIsStuck) {
  const PreparedScene scene = PreparedSmallScene();
  const CertifiedScene certified = Certified(scene, StuckAtOnce());
  const CertifiedMotion motion =
      Move(scene, certified, ThroughTheMuscles(), certified.rest);
  EXPECT_EQ(motion.summary.given_up, GivenUp::kStuck);
  EXPECT_NEAR(motion.summary.reached, 0.5, 0.1);
  EXPECT_EQ(motion.summary.steps, 1);
  EXPECT_EQ(motion.state.pose.name, "into the muscles");
  ASSERT_TRUE(motion.last_clean.has_value());
  EXPECT_EQ(LargestDifference(*motion.last_clean, certified.rest), 0);
}

TEST(MoveCertified, TakesAsManyStepsAsLeaveNoCrossings) {
  const PreparedScene scene = PreparedSmallScene();
  CertifiedContactOptions options;
  options.limits.max_turn = 0.02;
  options.max_stuck_steps = 1;
  const CertifiedScene certified = Certified(scene, options);
  const CertifiedMotion motion =
      Move(scene, certified, FlexedPose(0.1), certified.rest);
  EXPECT_GE(motion.summary.steps, 5);
  EXPECT_EQ(motion.summary.given_up, GivenUp::kNot);
}

TEST(MoveCertified, AsksAClockInPlaceOfStepsIfToldTo) {
  EXPECT_EQ(CertifiedContactOptions().frame_timeout_s,
            CertifiedContactOptions::kNoClock);
  const PreparedScene scene = PreparedSmallScene();
  CertifiedContactOptions options = StuckAtOnce();
  options.frame_timeout_s = 1e9;
  const CertifiedScene certified = Certified(scene, options);
  const CertifiedMotion motion =
      Move(scene, certified, ThroughTheMuscles(), certified.rest);
  EXPECT_NE(motion.summary.given_up, GivenUp::kStuck);
  EXPECT_GT(motion.summary.steps, 1);
}

TEST(MoveCertified, GoesTheRestOfTheWayWithoutContactWhenTheTimeRunsOut) {
  const PreparedScene scene = PreparedSmallScene();
  CertifiedContactOptions options;
  options.frame_timeout_s = 1e-9;
  const CertifiedScene certified = Certified(scene, options);
  const CertifiedMotion motion =
      Move(scene, certified, FlexedPose(0.3), certified.rest);
  EXPECT_EQ(motion.summary.given_up, GivenUp::kTimedOut);
  EXPECT_EQ(motion.summary.reached, 0);
  EXPECT_EQ(motion.summary.steps, 0);
  EXPECT_EQ(motion.state.pose.name, "flexed");
  EXPECT_GT(LargestDifference(motion.state, certified.rest), 1);
  EXPECT_EQ(LargestDifference(*motion.last_clean, certified.rest), 0);
}

// What a frame shows is in the order of the scene, contact has its own.
TEST(ShapesOf, AreInTheOrderOfTheScene) {
  Scene scene = SmallScene();
  scene.muscles[0].name = "z_left";
  const PreparedScene prepared = PreparedSmallScene(scene);
  const CertifiedScene certified = Certified(prepared);
  ContactState state = certified.rest;
  state.points[1].array() += 1;  // of z_left
  const MuscleShapes shapes = ShapesOf(certified, state);
  EXPECT_EQ(shapes.fine[0], state.points[1]);
  EXPECT_EQ(shapes.fine[1], state.points[0]);
  EXPECT_EQ(shapes.coarse[0], state.coarse[1]);
}

// A bone beside both muscles, about which they bend.
Scene SmallSceneWithABoneBeside() {
  Scene scene = SmallScene();
  const TriangleSoup ball = MovedBy(Icosphere(20, 4), {0, 28.5, 10});
  scene.bones.push_back({"ball", ball.points, ball.triangles});
  scene.bones.back().body = "femur";
  return scene;
}

// As a resumed run does it.
ContactState WrittenAndRead(const ContactState& state) {
  std::stringstream stream;
  cereal::BinaryOutputArchive output(stream);
  output(state);
  ContactState read;
  cereal::BinaryInputArchive input(stream);
  input(read);
  return read;
}

// Planes of bones are found in earlier steps, so that they must go with the
// state wherever a run is divided.
TEST(MoveCertified, DoesNotDependOnHowARunIsDivided) {
  const PreparedScene scene = PreparedSmallScene(SmallSceneWithABoneBeside());
  const CertifiedScene certified = Certified(scene);
  EXPECT_EQ(certified.rest.bone_planes, nullptr);
  constexpr int kPoses = 4;
  const auto end_of = [&](int divisions, bool keeps_planes) {
    ContactState state = certified.rest;
    for (int i = 0; i < kPoses; ++i) {
      if (divisions >> i & 1) state = WrittenAndRead(state);
      if (!keeps_planes) state.bone_planes = nullptr;
      state = Move(scene, certified, FlexedPose(0.02 * (i + 1)), state).state;
    }
    return state;
  };
  const ContactState whole = end_of(0, true);
  ASSERT_NE(whole.bone_planes, nullptr);
  EXPECT_TRUE(std::any_of(
      whole.bone_planes->begin(),
      whole.bone_planes->end(),
      [](const KeptPlanes& planes) { return !planes.spaces.empty(); }));
  for (int divisions = 1; divisions < 1 << kPoses; ++divisions) {
    EXPECT_EQ(LargestDifference(end_of(divisions, true), whole), 0)
        << divisions;
  }
  // They do matter.
  EXPECT_GT(LargestDifference(end_of(0, false), whole), 0);
}

TEST(MoveCertified, DoesNotDependOnTheLengthOfSteps) {
  const PreparedScene scene = PreparedSmallScene();
  const CertifiedScene certified = Certified(scene);
  CertifiedContactOptions options;
  options.limits = {RadiansOf(1), 10};
  const CertifiedScene short_steps = Certified(scene, options);
  const CertifiedMotion a =
      Move(scene, certified, FlexedPose(0.3), certified.rest);
  const CertifiedMotion b =
      Move(scene, short_steps, FlexedPose(0.3), short_steps.rest);
  EXPECT_LE(a.summary.steps, 3);
  EXPECT_GE(b.summary.steps, 17);
  EXPECT_LT(LargestDifference(a.state, b.state), 1e-3);
}

TEST(MoveCertified, DoesNotDependOnTheCoarseWeightWhereNothingIsInTheWay) {
  const PreparedScene scene = PreparedSmallScene();
  CertifiedContactOptions options;
  options.coarse_weight = 0;
  const CertifiedScene without = Certified(scene, options);
  const CertifiedScene with = Certified(scene);
  // A pose that moves nothing towards anything.
  ScenePose apart;
  apart.name = "apart";
  Eigen::Matrix4d up = Eigen::Matrix4d::Identity();
  up(2, 3) = 3;
  apart.bodies["femur"] = up;
  const CertifiedMotion a = Move(scene, without, apart, without.rest);
  const CertifiedMotion b = Move(scene, with, apart, with.rest);
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_LT((a.state.coarse[i] - b.state.coarse[i]).norm(), 1e-6);
  }
}

TEST(CertifiedContactOptions, NameWhatIsWrong) {
  CertifiedContactOptions options;
  std::string error;
  EXPECT_TRUE(options.IsValid(&error));
  options.max_returns = -1;
  EXPECT_FALSE(options.IsValid(&error));
  EXPECT_EQ(error,
            "CertifiedContactOptions::max_returns is -1, allowed: 0 or above");
  options = {};
  options.step.volume.tolerance = 0;
  EXPECT_FALSE(options.IsValid(&error));
  EXPECT_EQ(error, "VolumeOptions::tolerance is 0, allowed: above 0");
}

}  // namespace
}  // namespace musclewarp
