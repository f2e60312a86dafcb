// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/solved_pose.h"

#include <gtest/gtest.h>

#include "musclewarp/frames/scene_state.h"
#include "support/prepared_small_scene.h"

namespace musclewarp {
namespace {

// What the solvers stop at, and twice.
constexpr double kSolver = 1e-3;

TEST(SolvePose, ARestPoseIsKept) {
  const PreparedScene scene = PreparedSmallScene();
  const SceneState rest = RestState(scene);
  const SolvedPose solved = SolvePose(
      ModelsOf(scene), rest.pose, {}, ReferenceSolvers().single, rest.muscles);
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_LT(
        (solved.states[i].coarse - scene.muscles[i].model.coarse_rest).norm(),
        1e-6);
    EXPECT_TRUE(solved.summaries[i].IsSolutionUsable());
  }
}

TEST(Predict, IsExactButForTheVolume) {
  const PreparedScene scene = PreparedSmallScene();
  const SceneState rest = RestState(scene);
  const ScenePose pose = FlexedPose(0.2);
  const std::vector<MuscleState> predicted =
      Predict(ModelsOf(scene), rest.muscles, rest.pose, pose, {});
  for (size_t i = 0; i < 2; ++i) {
    const MuscleModel& model = scene.muscles[i].model;
    // From rest to the unconstrained minimiser.
    EXPECT_LT((predicted[i].coarse -
               UnconstrainedMinimizer(model, TargetOf(model, pose, {})))
                  .norm(),
              1e-9);
  }
}

TEST(SolvePose, TheResultDoesNotDependOnTheStart) {
  const PreparedScene scene = PreparedSmallScene();
  const SceneState rest = RestState(scene);
  const ScenePose pose = FlexedPose(0.2);
  const MuscleSolver solver = ReferenceSolvers().single;
  const SolvedPose one =
      SolvePose(ModelsOf(scene), pose, {}, solver, rest.muscles);
  const SolvedPose two =
      SolvePose(ModelsOf(scene),
                pose,
                {},
                solver,
                Predict(ModelsOf(scene), rest.muscles, rest.pose, pose, {}));
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_LT((one.states[i].coarse - two.states[i].coarse)
                  .rowwise()
                  .norm()
                  .maxCoeff(),
              kSolver);
  }
}

TEST(SolveWithRows, MovesTheMusclesThatHaveRowsAndNoOthers) {
  const PreparedScene scene = PreparedSmallScene();
  const SceneState rest = RestState(scene);
  const MuscleSolver solver = ReferenceSolvers().single;
  const SolvedPose free =
      SolvePose(ModelsOf(scene), rest.pose, {}, solver, rest.muscles);
  // Vertex 100 of the first muscle should be 2 mm farther along x.
  const Eigen::RowVector3d p = scene.muscles[0].model.fine_rest.row(100);
  std::vector<OneSidedRows> rows(2);
  rows[0] = OneSidedRowsOf({{100, {{1, 0, 0}, p[0] + 2}}}, 10);
  const SolvedPose solved = SolveWithRows(
      ModelsOf(scene), free, rest.pose, {}, solver, rows, free.states);
  EXPECT_EQ(solved.states[1].coarse, free.states[1].coarse);
  const Points fine =
      FinePoints(scene.muscles[0].model, {solved.states[0].coarse, {}});
  EXPECT_GT(fine(100, 0), p[0] + 1);
  // Iterations of both solves are added up.
  EXPECT_GT(solved.summaries[0].iterations, free.summaries[0].iterations);
}

TEST(SolveWithRows, AMuscleThatFailedWithoutRowsStaysFailed) {
  const PreparedScene scene = PreparedSmallScene();
  const SceneState rest = RestState(scene);
  const MuscleSolver solver = ReferenceSolvers().single;
  SolvedPose free =
      SolvePose(ModelsOf(scene), rest.pose, {}, solver, rest.muscles);
  free.summaries[0].stop_reason = StopReason::kFailed;
  free.summaries[0].message = "no step";
  std::vector<OneSidedRows> rows(2);
  rows[0] = OneSidedRowsOf({{100, {{1, 0, 0}, 0}}}, 1);
  const SolvedPose solved = SolveWithRows(
      ModelsOf(scene), free, rest.pose, {}, solver, rows, free.states);
  EXPECT_EQ(solved.summaries[0].stop_reason, StopReason::kFailed);
  EXPECT_EQ(solved.summaries[0].message, "no step");
}

}  // namespace
}  // namespace musclewarp
