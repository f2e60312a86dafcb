// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frame_solvers/certified_frame_solver.h"

#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "musclewarp/base/stopwatch.h"
#include "musclewarp/frame_solvers/certified_frame.h"
#include "musclewarp/frames/moment_arms.h"

namespace musclewarp {
namespace {

// `wall_ms` is the time of the whole frame so far.
std::string TimeoutShortcoming(double reached, double wall_ms) {
  std::ostringstream text;
  text << "timed out after " << static_cast<int>(wall_ms / 1000) << " s, at "
       << static_cast<int>(100 * reached)
       << " % of the motion; the remainder was computed without contact";
  return text.str();
}

// A step keeps muscles in the planes of what was near when it began. Along a
// rugged bone they may slide to where it comes nearer than the gap; another
// step then finds the planes that were missing.
constexpr int kMaxFurtherSteps = 2;

// Returns whether nothing crosses but two surfaces are nearer than the gap.
bool IsTooNear(const Frame& frame, double gap) {
  const std::optional<double> smallest = frame.intersections.SmallestGap();
  return frame.intersections.triangle_pairs == 0 && smallest && *smallest < gap;
}

}  // namespace

CertifiedFrameSolver::CertifiedFrameSolver(const PreparedScene& scene,
                                           const FrameSolverOptions& options,
                                           std::shared_ptr<SceneMeshes> meshes,
                                           RestResult rest)
    : FrameSolver(scene, options, std::move(meshes)),
      certified_(RestoreCertifiedScene(
          scene, *meshes_, options.certified, std::move(rest.state))) {
  contact_.rest = std::move(rest.intersections);
  contact_.displaced_at_rest = std::move(rest.displaced);
  contact_.options = {{"gap_mm", options.certified.step.gap}};
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
                                        const ScenePose& pose,
                                        const SceneState* before,
                                        const ProgressCallback& on_progress) {
  const Stopwatch moving;
  const ContactState& from = before ? *before->contact : certified_.rest;
  const std::vector<Points> points_before =
      before ? ShapesOf(certified_, from).fine : std::vector<Points>();
  const auto move_from = [&](const ContactState& start) {
    return MoveCertified(scene_,
                         certified_,
                         pose,
                         options_.pre_rotation,
                         solvers.single,
                         start,
                         on_progress);
  };
  const auto certify = [&](const CertifiedMotion& motion) {
    return CertifiedFrame(scene_,
                          certified_,
                          options_.requirements,
                          motion.state,
                          points_before,
                          motion.summary.summaries,
                          meshes_.get());
  };
  CertifiedMotion motion = move_from(from);
  double wall_ms = moving.Milliseconds();
  Stopwatch certifying;
  SolvedFrame result;
  result.frame = certify(motion);
  for (int further = 0; further < kMaxFurtherSteps && !motion.last_clean &&
                        IsTooNear(result.frame, options_.certified.step.gap);
       ++further) {
    const int steps = motion.summary.steps;
    motion = move_from(motion.state);
    motion.summary.steps += steps;
    wall_ms = moving.Milliseconds();
    certifying = Stopwatch();
    result.frame = certify(motion);
  }
  Frame& frame = result.frame;
  if (motion.summary.timed_out_at) {
    frame.shortcomings.insert(
        frame.shortcomings.begin(),
        TimeoutShortcoming(*motion.summary.timed_out_at, wall_ms));
  }
  frame.pose_steps = motion.summary.steps;
  frame.wall_ms = wall_ms;
  frame.solve_ms = wall_ms;
  frame.certify_ms = certifying.Milliseconds();
  AddMomentArms(scene_,
                pose,
                options_.pre_rotation,
                {ShapesOf(certified_, motion.state).coarse,
                 ContactRowsOf(certified_, motion.state),
                 FreeCoarseOf(certified_, motion.state)},
                &frame);
  ContactState& next = motion.last_clean ? *motion.last_clean : motion.state;
  result.state.pose = next.pose;
  result.state.contact = std::move(next);
  return result;
}

}  // namespace musclewarp
