// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frame_solvers/free_frame_solver.h"

#include <algorithm>
#include <utility>

#include "musclewarp/base/stopwatch.h"
#include "musclewarp/frames/frame_measures.h"
#include "musclewarp/frames/moment_arms.h"
#include "musclewarp/motion/pose_pushes.h"
#include "musclewarp/motion/solved_pose.h"

namespace musclewarp {

FreeFrameSolver::FreeFrameSolver(const PreparedScene& scene,
                                 const FrameSolverOptions& options,
                                 std::shared_ptr<SceneMeshes> meshes)
    : FrameSolver(scene, options, std::move(meshes)) {}

SceneState FreeFrameSolver::StartOfMotion(const MuscleSolvers& /*solvers*/) {
  return RestState(scene_);
}

int FreeFrameSolver::ExpectedSteps(const ScenePose* /*from*/,
                                   const ScenePose& /*pose*/) const {
  return 1;
}

SolvedFrame FreeFrameSolver::Solve(const MuscleSolvers& solvers,
                                   const ScenePose& given_pose,
                                   const SceneState* before,
                                   const ProgressCallback& on_progress) {
  if (on_progress) on_progress({"moving", 0, 1, ""});
  const Stopwatch moving;
  const ScenePose pose = WithPushes(scene_, options_.pre_rotation, given_pose);
  const MuscleModels models = ModelsOf(scene_);
  SolvedPose solved = SolvePose(models,
                                pose,
                                options_.pre_rotation,
                                solvers.single,
                                before ? Predict(models,
                                                 before->muscles,
                                                 before->pose,
                                                 pose,
                                                 options_.pre_rotation)
                                       : RestState(scene_).muscles);
  const double wall_ms = moving.Milliseconds();
  const Stopwatch certifying;
  SolvedFrame result;
  result.frame = MeasureFrame(scene_,
                              pose,
                              ShapesOf(scene_, solved.states),
                              FinePointsOf(scene_, before),
                              std::move(solved.summaries),
                              meshes_.get(),
                              options_.measures);
  result.frame.shortcomings = ShortcomingsOf(result.frame);
  result.frame.wall_ms = wall_ms;
  result.frame.solve_ms = solved.solve_ms;
  result.frame.certify_ms = certifying.Milliseconds();
  AddMomentArms(scene_,
                pose,
                options_.pre_rotation,
                {ShapesOf(scene_, solved.states), {}, {}},
                &result.frame);
  result.state = {pose, std::move(solved.states), std::nullopt};
  return result;
}

// Without contact, only the shapes are judged.
std::vector<std::string> FreeFrameSolver::ShortcomingsOf(
    const Frame& frame) const {
  constexpr double kMaxVolumeError = 1e-6;
  std::vector<JudgedMuscle> muscles;
  for (size_t i = 0; i < frame.muscles.size(); ++i) {
    muscles.push_back(JudgedMuscleOf(scene_.muscles[i], frame.muscles[i]));
  }
  FrameRequirements requirements = options_.requirements;
  requirements.max_volume_error =
      std::min(requirements.max_volume_error, kMaxVolumeError);
  requirements.body_size = scene_.scene.body_size;
  return ShapeShortcomings(requirements, muscles);
}

}  // namespace musclewarp
