// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frame_solvers/frame_solver.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "musclewarp/frame_solvers/rest_separation.h"
#include "support/prepared_small_scene.h"

namespace musclewarp {
namespace {

using ::testing::HasSubstr;

std::unique_ptr<FrameSolver> SolverFor(const PreparedScene& scene,
                                       const FrameSolverOptions& options) {
  std::optional<RestResult> rest;
  if (options.contact == ContactKind::kCertified) {
    PreparedScene separated = scene;
    RestSeparationOptions separation;
    separation.contact = options.certified;
    rest = SeparateRest(separation, ReferenceSolvers().single, {}, &separated);
  }
  return MakeFrameSolver(
      scene, options, std::make_shared<SceneMeshes>(scene), std::move(rest));
}

TEST(FrameSolver, WithoutContactDoesNotDependOnTheWay) {
  const PreparedScene scene = PreparedSmallScene();
  FrameSolverOptions options;
  options.contact = ContactKind::kNone;
  const auto solver = SolverFor(scene, options);
  const MuscleSolvers solvers = ReferenceSolvers();
  const Frame alone =
      solver->Solve(solvers, FlexedPose(0.2), nullptr, {}).frame;
  SceneState state = solver->StartOfMotion(solvers);
  for (const double angle : {0.3, -0.1, 0.2}) {
    state = solver->Solve(solvers, FlexedPose(angle), &state, {}).state;
  }
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_LT((FinePoints(scene.muscles[i].model, state.muscles[i]) -
               alone.muscles[i].points)
                  .rowwise()
                  .norm()
                  .maxCoeff(),
              1e-3);  // what the solver stops at, and twice
  }
}

TEST(FrameSolver, SaysWhatContactItIs) {
  const PreparedScene scene = PreparedSmallScene();
  FrameSolverOptions options;
  options.contact = ContactKind::kNone;
  EXPECT_FALSE(SolverFor(scene, options)->contact().rest.has_value());
  options.contact = ContactKind::kPaper;
  const auto paper = SolverFor(scene, options);
  EXPECT_EQ(paper->contact().level, "coarse");
  EXPECT_TRUE(paper->contact().rest.has_value());
  options.contact = ContactKind::kCertified;
  options.certified.step.gap = 0.15;
  const auto certified = SolverFor(scene, options);
  EXPECT_EQ(certified->contact().gap, 0.15);
  EXPECT_TRUE(certified->contact().rest->IsClean());
}

TEST(FrameSolver, CertifiedFramesKeepTheGap) {
  const PreparedScene scene = PreparedSmallScene();
  FrameSolverOptions options;
  options.certified.step.gap = 0.2;
  const auto solver = SolverFor(scene, options);
  const MuscleSolvers solvers = ReferenceSolvers();
  SceneState state = solver->StartOfMotion(solvers);
  double least = 1e300;
  for (const double shift : {2, 4, 6}) {
    // The line of the right muscle goes towards the left one.
    ScenePose pose;
    Points& line = pose.lines["right_line"];
    line = scene.scene.muscles[1].lines[0].rest;
    line.col(0).array() -= shift;
    SolvedFrame solved = solver->Solve(solvers, pose, &state, {});
    EXPECT_TRUE(solved.frame.IsUsable()) << solved.frame.FullReport();
    for (const MuscleFrame& muscle : solved.frame.muscles) {
      least = std::min(least, muscle.gaps.minCoeff());
    }
    state = std::move(solved.state);
  }
  // In contact, and not nearer than another round would be made for.
  EXPECT_GT(least, 0.2 * options.certified.step.gap);
  EXPECT_LT(least, 1);
}

TEST(FrameSolver, CertifiedFramesKeepAttachmentsOnTheirBones) {
  const PreparedScene scene = PreparedSmallScene();
  const auto solver = SolverFor(scene, {});
  const MuscleSolvers solvers = ReferenceSolvers();
  SceneState state = solver->StartOfMotion(solvers);
  for (const double angle : {0.0, 0.2, 0.4}) {
    SolvedFrame solved = solver->Solve(solvers, FlexedPose(angle), &state, {});
    EXPECT_TRUE(solved.frame.IsUsable()) << solved.frame.FullReport();
    for (const MuscleFrame& muscle : solved.frame.muscles) {
      ASSERT_EQ(muscle.attachments.size(), 2u);
      for (const AttachmentDrift& drift : muscle.attachments) {
        EXPECT_GT(drift.vertices, 5);
        // The reach does not hold back what is carried so near.
        EXPECT_LT(drift.max, 1e-6) << drift.body << " at " << angle;
      }
    }
    state = std::move(solved.state);
  }
}

TEST(FrameSolver, WithoutContactTheDriftIsMeasured) {
  const PreparedScene scene = PreparedSmallScene();
  FrameSolverOptions options;
  options.contact = ContactKind::kNone;
  const Frame frame =
      SolverFor(scene, options)
          ->Solve(ReferenceSolvers(), FlexedPose(0.4), nullptr, {})
          .frame;
  // The coarse mesh follows, but is not held.
  EXPECT_GT(frame.muscles[0].attachments[1].max, 1e-3);
  EXPECT_LT(frame.muscles[0].attachments[1].max, 5);
}

// The same motion against requirements that no frame meets: what is measured is
// what is judged.
TEST(FrameSolver, CertifiedFramesAreJudged) {
  const PreparedScene scene = PreparedSmallScene();
  FrameSolverOptions options;
  options.requirements.displacement_allowance = 0;
  options.requirements.least_displacement = 0;
  options.requirements.displacement_per_depth = 0;
  options.requirements.max_volume_error = 0;
  const auto solver = SolverFor(scene, options);
  const Frame frame =
      solver->Solve(ReferenceSolvers(), FlexedPose(0.3), nullptr, {}).frame;
  EXPECT_FALSE(frame.IsUsable());
  EXPECT_THAT(frame.FullReport(), HasSubstr("volume off by"));
  EXPECT_THAT(frame.FullReport(), HasSubstr("mm by contact, allowed 0"));
}

TEST(FrameSolver, CertifiedFramesSayWhereTheyWereGivenUp) {
  const PreparedScene scene = PreparedSmallScene();
  FrameSolverOptions options;
  // Two steps for the way, with nothing done against crossings.
  options.certified.limits = {M_PI, 60};
  options.certified.unchecked_fraction = 1;
  options.certified.max_halvings = 0;
  options.certified.max_returns = 0;
  options.certified.max_reach = options.certified.step.reach;
  options.certified.step.max_rounds = 1;
  options.certified.max_stuck_steps = 1;
  const auto solver = SolverFor(scene, options);
  ScenePose pose;
  pose.bodies["femur"] = Eigen::Matrix4d::Identity();
  pose.bodies["femur"](2, 3) = -120;  // through the muscles
  const Frame frame =
      solver->Solve(ReferenceSolvers(), pose, nullptr, {}).frame;
  EXPECT_FALSE(frame.IsUsable());
  EXPECT_THAT(frame.FullReport(),
              HasSubstr("given up, as triangles crossed for 1 step, at"));
  EXPECT_THAT(frame.FullReport(),
              HasSubstr("the remainder was computed without contact"));
}

TEST(ContactKind, HasTheNamesOfTheFlag) {
  EXPECT_EQ(ToString(ContactKind::kNone), "none");
  EXPECT_EQ(ToString(ContactKind::kPaper), "paper");
  EXPECT_EQ(ToString(ContactKind::kCertified), "certified");
}

TEST(FrameSolverOptions, CheckAllThatIsWithin) {
  FrameSolverOptions options;
  std::string error;
  EXPECT_TRUE(options.IsValid(&error));
  options.paper_limits.max_move = 0;
  EXPECT_FALSE(options.IsValid(&error));
  EXPECT_EQ(error, "StepLimits::max_move is 0, allowed: above 0");
}

}  // namespace
}  // namespace musclewarp
