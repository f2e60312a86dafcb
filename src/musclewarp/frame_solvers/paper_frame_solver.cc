// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frame_solvers/paper_frame_solver.h"

#include <Eigen/LU>
#include <utility>

#include "musclewarp/base/stopwatch.h"
#include "musclewarp/frames/frame_measures.h"
#include "musclewarp/frames/moment_arms.h"
#include "musclewarp/motion/muscle_solvers.h"
#include "musclewarp/scene/line_targets.h"

namespace musclewarp {

PaperFrameSolver::PaperFrameSolver(const PreparedScene& scene,
                                   const FrameSolverOptions& options,
                                   std::shared_ptr<SceneMeshes> meshes)
    : FrameSolver(scene, options, std::move(meshes)),
      paper_(PreparePaperScene(scene, options.paper)) {
  const GroupContactOptions& group = options.paper.group;
  contact_.name += "/" + ToString(group.level);
  contact_.is_solved_together = true;
  contact_.level = ToString(group.level);
  contact_.seed = group.paper.seed;
  contact_.warnings = paper_.warnings;
  contact_.prepare_ms = paper_.wall_ms;
  std::vector<MuscleState> fixed = RestState(scene).muscles;
  ContactInPose(scene, paper_, ScenePose()).Start(&fixed);
  contact_.rest =
      IntersectAtRest(scene, ShapesOf(scene, fixed).fine, meshes_.get());
}

SolvedPose PaperFrameSolver::SolveGroup(const GroupSolver& solver,
                                        const ScenePose& pose,
                                        const SceneState* before) const {
  const MuscleModels models = ModelsOf(scene_);
  std::vector<MuscleTarget> targets;
  SolvedPose solved;
  for (const PreparedMuscle& muscle : scene_.muscles) {
    targets.push_back(TargetOf(muscle.model, pose, options_.pre_rotation));
    if (before) continue;
    MuscleState start;
    start.coarse = UnconstrainedMinimizer(muscle.model, targets.back());
    solved.states.push_back(std::move(start));
  }
  GroupContact contact = ContactInPose(scene_, paper_, pose);
  if (before) {
    solved.states = Predict(
        models, before->muscles, before->pose, pose, options_.pre_rotation);
    std::vector<Eigen::Matrix4d> now_from_before;
    for (const PreparedBone& bone : scene_.bones) {
      now_from_before.push_back(
          BodyTransform(pose, bone.body) *
          BodyTransform(before->pose, bone.body).inverse());
    }
    contact.FollowOn(before->muscles, std::move(now_from_before));
  }
  const std::vector<MuscleState> start = solved.states;
  const Stopwatch solving;
  solver(models, targets, &contact, &solved.states, &solved.summaries);
  solved.solve_ms = solving.Milliseconds();
  for (size_t i = 0; i < start.size(); ++i) {
    KeepFinite(*models[i], start[i], &solved.states[i], &solved.summaries[i]);
  }
  return solved;
}

SceneState PaperFrameSolver::StateOf(const ScenePose& pose,
                                     const SolvedPose& solved) const {
  const bool keeps_offset = options_.paper.group.level == ContactLevel::kFine;
  SceneState state;
  state.pose = pose;
  for (const MuscleState& muscle : solved.states) {
    MuscleState kept;
    kept.coarse = muscle.coarse;
    if (keeps_offset) {
      kept.corrections.fine_offset = muscle.corrections.fine_offset;
    }
    state.muscles.push_back(std::move(kept));
  }
  return state;
}

SceneState PaperFrameSolver::StartOfMotion(const MuscleSolvers& solvers) {
  const ScenePose rest = RestPose(scene_.scene);
  return StateOf(rest, SolveGroup(solvers.group, rest, nullptr));
}

int PaperFrameSolver::ExpectedSteps(const ScenePose* from,
                                    const ScenePose& pose) const {
  if (!from) return 1;
  return StepsBetween(scene_.scene, *from, pose, options_.paper_limits);
}

SolvedFrame PaperFrameSolver::Solve(const MuscleSolvers& solvers,
                                    const ScenePose& pose,
                                    const SceneState* before,
                                    const ProgressCallback& on_progress) {
  const Stopwatch moving;
  const int steps = ExpectedSteps(before ? &before->pose : nullptr, pose);
  double solve_ms = 0;
  SceneState state = before ? *before : SceneState();
  SolvedPose solved;
  for (int i = 1; i <= steps; ++i) {
    if (on_progress) on_progress({"moving", i - 1, steps, ""});
    const ScenePose target = i == steps
                                 ? pose
                                 : PoseBetween(scene_.scene,
                                               before->pose,
                                               pose,
                                               static_cast<double>(i) / steps);
    solved = SolveGroup(solvers.group, target, before ? &state : nullptr);
    solve_ms += solved.solve_ms;
    state = StateOf(target, solved);
  }
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
  result.frame.pose_steps = steps;
  result.frame.wall_ms = wall_ms;
  result.frame.solve_ms = solve_ms;
  result.frame.certify_ms = certifying.Milliseconds();
  AddPathMomentArms(scene_, pose, &result.frame);
  result.state = std::move(state);
  return result;
}

}  // namespace musclewarp
