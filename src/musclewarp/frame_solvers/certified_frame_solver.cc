// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frame_solvers/certified_frame_solver.h"

#include <string>
#include <utility>
#include <vector>

#include "musclewarp/base/stopwatch.h"
#include "musclewarp/frame_solvers/certified_frame.h"
#include "musclewarp/frame_solvers/further_motions.h"
#include "musclewarp/frames/moment_arms.h"
#include "musclewarp/motion/pose_pushes.h"

namespace musclewarp {
namespace {

// Returns why a motion was given up, in words. `wall_ms`: the time that it
// took.
std::string WhyGivenUp(GivenUp reason, int max_stuck_steps, double wall_ms) {
  switch (reason) {
    case GivenUp::kNot:
      break;
    case GivenUp::kTimedOut:
      return "timed out after " +
             std::to_string(static_cast<int>(wall_ms / 1000)) + " s";
    case GivenUp::kStuck:
      return "given up, as triangles crossed for " +
             std::to_string(max_stuck_steps) +
             (max_stuck_steps == 1 ? " step" : " steps in a row");
    case GivenUp::kNotFinite:
      return "given up, as every step came to coordinates that are not finite";
  }
  return "";
}

// Returns a sentence if a motion was given up.
std::vector<std::string> GivenUpIn(const MotionSummary& summary,
                                   int max_stuck_steps,
                                   double wall_ms) {
  std::vector<std::string> shortcomings;
  if (summary.given_up == GivenUp::kNot) return shortcomings;
  shortcomings.push_back(
      WhyGivenUp(summary.given_up, max_stuck_steps, wall_ms) + ", at " +
      std::to_string(static_cast<int>(100 * summary.reached)) +
      " % of the motion; the remainder was computed without contact");
  return shortcomings;
}

}  // namespace

CertifiedFrameSolver::CertifiedFrameSolver(const PreparedScene& scene,
                                           const FrameSolverOptions& options,
                                           std::shared_ptr<SceneMeshes> meshes,
                                           RestResult rest)
    : FrameSolver(scene, options, std::move(meshes)),
      certified_(RestoreCertifiedScene(
          scene, options.certified, std::move(rest.state))) {
  contact_.rest = std::move(rest.intersections);
  contact_.displaced_at_rest = std::move(rest.displaced);
  contact_.gap = options.certified.step.gap;
  contact_.prepare_ms = rest.wall_ms + certified_.wall_ms;
}

SceneState CertifiedFrameSolver::StartOfMotion(
    const MuscleSolvers& /*solvers*/) {
  return {certified_.rest.pose, {}, certified_.rest};
}

int CertifiedFrameSolver::ExpectedSteps(const ScenePose* from,
                                        const ScenePose& pose) const {
  const CertifiedContactOptions& options = options_.certified;
  return StepsBetween(scene_.scene,
                      from ? *from : certified_.rest.pose,
                      pose,
                      {options.unchecked_fraction * options.limits.max_turn,
                       options.unchecked_fraction * options.limits.max_move});
}

SolvedFrame CertifiedFrameSolver::Solve(const MuscleSolvers& solvers,
                                        const ScenePose& given_pose,
                                        const SceneState* before,
                                        const ProgressCallback& on_progress) {
  const Stopwatch pushing;
  const ScenePose pose = WithPushes(scene_, options_.pre_rotation, given_pose);
  const double pushing_ms = pushing.Milliseconds();
  const ContactState& from = before ? *before->contact : certified_.rest;
  const std::vector<Points> points_before =
      before ? ShapesOf(certified_, from).fine : std::vector<Points>();
  const auto move = [&](const ContactState& start, Settling settling) {
    const Stopwatch moving;
    CertifiedMove moved;
    moved.motion = MoveCertified(scene_,
                                 certified_,
                                 pose,
                                 options_.pre_rotation,
                                 solvers.single,
                                 start,
                                 settling,
                                 on_progress);
    moved.moving_ms = moving.Milliseconds();
    const Stopwatch certifying;
    moved.frame = CertifiedFrame(scene_,
                                 certified_,
                                 options_.requirements,
                                 moved.motion.state,
                                 points_before,
                                 moved.motion.summary.summaries,
                                 meshes_.get(),
                                 options_.measures);
    moved.certifying_ms = certifying.Milliseconds();
    return moved;
  };
  CertifiedMove moved = MoveUntilSound(
      move, from, options_.certified.step.gap, options_.requirements);
  CertifiedMotion& motion = moved.motion;
  SolvedFrame result;
  result.frame = std::move(moved.frame);
  Frame& frame = result.frame;
  const std::vector<std::string> given_up = GivenUpIn(
      motion.summary, options_.certified.max_stuck_steps, moved.moving_ms);
  frame.shortcomings.insert(
      frame.shortcomings.begin(), given_up.begin(), given_up.end());
  frame.pose_steps = motion.summary.steps;
  frame.wall_ms = pushing_ms + moved.moving_ms;
  frame.solve_ms = frame.wall_ms;
  frame.certify_ms = moved.certifying_ms;
  AddMomentArms(scene_,
                pose,
                options_.pre_rotation,
                {InterpolatedShapesOf(certified_, motion.state),
                 ContactRowsOf(certified_, motion.state),
                 FreeCoarseOf(certified_, motion.state)},
                &frame);
  ContactState& next = motion.last_clean ? *motion.last_clean : motion.state;
  result.state.pose = next.pose;
  result.state.contact = std::move(next);
  return result;
}

}  // namespace musclewarp
