// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/certified_stepper.h"

#include <glog/logging.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "musclewarp/scene/line_targets.h"

namespace musclewarp {
namespace {

// Returns the fine vertices of the muscles, in the order of contact.
std::vector<Points> FineMeshes(const Mover& mover,
                               const std::vector<MuscleState>& muscles) {
  const std::vector<int>& order = mover.certified.order;
  std::vector<Points> meshes(order.size());
#pragma omp parallel for schedule(dynamic, 1)
  for (size_t k = 0; k < order.size(); ++k) {
    meshes[k] =
        FinePoints(mover.scene.muscles[order[k]].model, muscles[order[k]]);
  }
  return meshes;
}

std::vector<MuscleState> WithoutOffsets(
    const std::vector<MuscleState>& muscles) {
  std::vector<MuscleState> coarse;
  for (const MuscleState& muscle : muscles) {
    coarse.push_back({muscle.coarse, {}});
  }
  return coarse;
}

std::vector<Eigen::Matrix4d> BonesFromRest(const PreparedScene& scene,
                                           const ScenePose& pose) {
  std::vector<Eigen::Matrix4d> transforms;
  for (const PreparedBone& bone : scene.bones) {
    transforms.push_back(BodyTransform(pose, bone.body));
  }
  return transforms;
}

SolvedPose SolveFree(const Mover& mover,
                     const Place& from,
                     const ScenePose& pose) {
  const SceneState before = {from.pose, from.free.states, {}};
  return SolvePose(mover.scene,
                   pose,
                   mover.pre_rotation,
                   mover.solver,
                   Predict(mover.scene, before, pose, mover.pre_rotation));
}

// Solves the muscles with rows for the planes that their samples violate most.
SolvedPose SolveWithContactRows(const Mover& mover,
                                const OpenStep& open,
                                const std::vector<Points>& targets,
                                const ScenePose& pose,
                                const SolvedPose& free,
                                const SolvedPose& start) {
  const CertifiedScene& certified = mover.certified;
  std::vector<OneSidedRows> rows(mover.scene.muscles.size());
  for (size_t k = 0; k < certified.order.size(); ++k) {
    rows[certified.order[k]] =
        OneSidedRowsOf(open.planes.MostViolated(static_cast<int>(k),
                                                certified.samples[k],
                                                open.relaxed.points[k],
                                                targets[k]),
                       certified.options.coarse_weight);
  }
  return SolveWithRows(mover.scene,
                       free,
                       pose,
                       mover.pre_rotation,
                       mover.solver,
                       std::move(rows),
                       start.states);
}

// One step: planes, half of the sweeps, the coarse solve with contact rows, the
// other half, and rounds until nothing crosses. `start` is where the coarse
// meshes are predicted.
Attempt TryStep(const Mover& mover,
                const StepOptions& options,
                const Place& from,
                const ScenePose& pose,
                const SolvedPose& free,
                const SolvedPose& start) {
  Attempt attempt;
  attempt.place.pose = pose;
  attempt.place.free = free;
  attempt.place.solved = start;
  std::vector<Points> targets = FineMeshes(mover, start.states);
  const ContactStep step = MakeContactStep(mover.certified.contact,
                                           from.surfaces,
                                           targets,
                                           BonesFromRest(mover.scene, pose));
  const bool has_rows = mover.certified.options.coarse_weight > 0;
  const int sweeps_before = has_rows ? options.sweeps / 2 : 0;
  OpenStep open = BeginStep(options, step, targets, sweeps_before);
  if (has_rows) {
    attempt.place.solved =
        SolveWithContactRows(mover, open, targets, pose, free, start);
    targets = FineMeshes(mover, attempt.place.solved.states);
  }
  StepResult result = FinishStep(
      options, step, targets, options.sweeps - sweeps_before, std::move(open));
  attempt.place.surfaces = std::move(result.state);
  attempt.summary = result.summary;
  return attempt;
}

// The distance that all vertices but a few move by less than, mm. Few are one
// in five hundred: where muscles are squeezed, single vertices never settle.
double MoveOfMost(const std::vector<Points>& a, const std::vector<Points>& b) {
  std::vector<double> moves;
  for (size_t i = 0; i < a.size(); ++i) {
    for (Eigen::Index v = 0; v < a[i].rows(); ++v) {
      moves.push_back((a[i].row(v) - b[i].row(v)).norm());
    }
  }
  if (moves.empty()) return 0;
  const auto most = moves.end() - 1 - static_cast<int>(moves.size() / 500);
  std::nth_element(moves.begin(), most, moves.end());
  return *most;
}

// Predicts the coarse meshes of the next step: they keep the displacement by
// contact that they have.
SolvedPose MovedAlong(const Place& from, const SolvedPose& free) {
  SolvedPose start = free;
  for (size_t i = 0; i < start.states.size(); ++i) {
    start.states[i].coarse +=
        from.solved.states[i].coarse - from.free.states[i].coarse;
  }
  return start;
}

}  // namespace

Place PlaceOf(const Mover& mover, const SceneState& state) {
  Place place;
  place.pose = state.pose;
  for (const Points& coarse : state.free_coarse) {
    place.free.states.push_back({coarse, {}});
  }
  place.free.summaries.resize(state.muscles.size());
  place.solved.states = WithoutOffsets(state.muscles);
  place.solved.summaries = place.free.summaries;
  place.surfaces.targets = FineMeshes(mover, place.solved.states);
  place.surfaces.points = place.surfaces.targets;
  for (size_t k = 0; k < mover.certified.order.size(); ++k) {
    const MuscleState& muscle = state.muscles[mover.certified.order[k]];
    if (muscle.corrections.fine_offset.rows() == 0) continue;
    place.surfaces.points[k] += muscle.corrections.fine_offset;
  }
  place.surfaces.bones_from_rest = BonesFromRest(mover.scene, state.pose);
  return place;
}

SceneState StateOf(const Mover& mover, const Place& place) {
  SceneState state;
  state.pose = place.pose;
  state.muscles = place.solved.states;
  for (const MuscleState& muscle : place.free.states) {
    state.free_coarse.push_back(muscle.coarse);
  }
  for (size_t k = 0; k < mover.certified.order.size(); ++k) {
    state.muscles[mover.certified.order[k]].corrections.fine_offset =
        place.surfaces.points[k] - place.surfaces.targets[k];
  }
  return state;
}

int Walk(const Mover& mover,
         const WalkOptions& options,
         const ScenePose& goal,
         double at,
         const ProgressCallback& on_progress,
         Place* place) {
  const ScenePose from = place->pose;
  const double shortest = options.longest_step / (1 << options.max_halvings);
  double length = options.longest_step;
  StepOptions step_options = options.step;
  double& reach = step_options.reach;
  int steps = 0, settling_steps = 0;
  while (at < 1 || settling_steps < options.max_settling_steps) {
    const bool settles = at >= 1;
    settling_steps += settles;
    if (on_progress) {
      on_progress(settles
                      ? Progress{"relaxing", steps, options.max_settling_steps}
                      : Progress{"moving", static_cast<int>(100 * at), 100});
    }
    // A step that ends just before the pose would leave one of rounding size.
    const double to = at + 1.01 * length >= 1 ? 1 : at + length;
    const ScenePose pose =
        to == 1 ? goal : PoseBetween(mover.scene.scene, from, goal, to);
    const SolvedPose free =
        settles ? place->free : SolveFree(mover, *place, pose);
    Attempt attempt =
        TryStep(mover,
                step_options,
                *place,
                pose,
                free,
                settles ? place->solved : MovedAlong(*place, free));
    ++steps;
    VLOG(1) << "step to " << to << " with reach " << reach << ": "
            << attempt.summary.rounds << " rounds, "
            << attempt.summary.crossing_pairs << " crossing pairs, "
            << (attempt.summary.is_intersection_free ? "free" : "not free")
            << ", most move by "
            << MoveOfMost(place->surfaces.points,
                          attempt.place.surfaces.points)
            << " mm";
    const bool crosses = options.accepts_self_crossings
                             ? attempt.summary.crossing_pairs > 0
                             : !attempt.summary.is_intersection_free;
    if (crosses && !settles && length > 1.01 * shortest) {
      length /= 2;
      continue;
    }
    if (crosses && reach < options.max_reach) {
      reach = std::min(options.reach_growth * reach, options.max_reach);
      continue;
    }
    if (crosses && settles) break;
    if (!crosses) length = std::min(options.longest_step, 2 * length);
    reach = options.step.reach;
    const bool has_settled =
        settles &&
        MoveOfMost(place->surfaces.points, attempt.place.surfaces.points) <
            options.settling_tolerance;
    *place = std::move(attempt.place);
    at = to;
    if (has_settled) break;
  }
  return steps;
}

}  // namespace musclewarp
