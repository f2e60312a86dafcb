// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/certified_motion.h"

#include <glog/logging.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "musclewarp/base/option_check.h"
#include "musclewarp/base/stopwatch.h"
#include "musclewarp/geometry/spread_points.h"
#include "musclewarp/scene/line_targets.h"

namespace musclewarp {
namespace {

// What does not change while a scene moves.
struct Mover {
  const PreparedScene& scene;
  const CertifiedScene& certified;
  const PreRotationOptions& pre_rotation;
  const MuscleSolver& solver;
};

// Where a scene has come to.
struct Place {
  ScenePose pose;
  SolvedPose free;    // without contact: what displacement is measured against
  SolvedPose solved;  // with contact rows
  ContactState surfaces;
};

// A step that was tried from one place to another.
struct Attempt {
  Place place;
  StepSummary summary;
};

// How a scene goes from one place to another.
struct WalkOptions {
  StepOptions step;
  double longest_step = 1;  // as a share of the way
  int max_halvings = 0;

  // A step that cannot be halved is tried again with more reach.
  double reach_growth = 1;
  double max_reach = 0;  // mm

  // Once the pose is reached, steps go on there until nothing moves by more
  // than the tolerance, mm.
  int max_settling_steps = 0;
  double settling_tolerance = 0;

  // If true, a step may leave more crossings of a muscle with itself.
  bool accepts_self_crossings = false;
};

// In the order of contact.
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
// meshes are expected.
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

double LargestMove(const std::vector<Points>& a, const std::vector<Points>& b) {
  double most = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    most = std::max(most, (a[i] - b[i]).rowwise().norm().maxCoeff());
  }
  return most;
}

// Where the coarse meshes are expected in the next step: what contact has moved
// them by goes along.
SolvedPose MovedAlong(const Place& from, const SolvedPose& free) {
  SolvedPose start = free;
  for (size_t i = 0; i < start.states.size(); ++i) {
    start.states[i].coarse +=
        from.solved.states[i].coarse - from.free.states[i].coarse;
  }
  return start;
}

// Moves on from `place` to a pose, and settles there. `at` is the share of the
// way that is behind: 1 if the place is the pose already. Returns the number of
// steps.
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
    // Rounding must not leave a last step of nothing.
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
    const double moved =
        LargestMove(place->surfaces.points, attempt.place.surfaces.points);
    *place = std::move(attempt.place);
    at = to;
    if (settles && moved < options.settling_tolerance) break;
  }
  return steps;
}

std::vector<int> OrderOfNames(const PreparedScene& scene) {
  std::vector<int> order(scene.muscles.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return scene.muscles[a].model.name < scene.muscles[b].model.name;
  });
  return order;
}

// The exempt areas with muscles numbered in the order of contact.
std::vector<ExemptArea> ExemptInOrder(const PreparedScene& scene,
                                      const std::vector<int>& order) {
  std::vector<ExemptArea> exempt = scene.exempt;
  for (ExemptArea& area : exempt) {
    const auto place = std::find(order.begin(), order.end(), area.muscle);
    area.muscle = static_cast<int>(place - order.begin());
  }
  return exempt;
}

void AddSurfaces(const PreparedScene& scene,
                 const std::vector<ExemptArea>& exempt,
                 CertifiedScene* certified) {
  const CertifiedContactOptions& options = certified->options;
  for (const int i : certified->order) {
    const MuscleModel& model = scene.muscles[i].model;
    certified->contact.muscles.push_back(MakeMuscleSurface(model.fine_rest,
                                                           model.fine_triangles,
                                                           model.rest_volume,
                                                           options.surface));
    certified->samples.push_back(SpreadPoints(
        model.fine_rest,
        static_cast<int>(options.samples_per_coarse_vertex *
                         static_cast<double>(model.coarse_rest.rows()))));
  }
  for (const PreparedBone& bone : scene.bones) {
    certified->contact.bones.push_back(
        std::make_shared<TriangleBvh>(bone.rest.points, bone.rest.triangles));
  }
  for (const ExemptArea& area : exempt) {
    auto& of_muscle = certified->contact.muscles[area.muscle].exempt;
    of_muscle.resize(scene.bones.size());
    of_muscle[area.bone] = area.triangles;
  }
}

}  // namespace

bool CertifiedContactOptions::IsValid(std::string* error) const {
  return OptionCheck("CertifiedContactOptions", error)
             .IsAbove("samples_per_coarse_vertex", samples_per_coarse_vertex, 0)
             .IsAtLeast("coarse_weight", coarse_weight, 0)
             .IsAtLeast("max_rest_steps", max_rest_steps, 0)
             .IsAtLeast("rest_sweeps", rest_sweeps, 1)
             .IsAbove("rest_tolerance", rest_tolerance, 0)
             .IsAbove("reach_growth", reach_growth, 1)
             .IsAbove("max_rest_reach", max_rest_reach, 0)
             .IsWithin("max_halvings", max_halvings, 0, 20)
             .is_valid() &&
         surface.IsValid(error) && separation.IsValid(error) &&
         step.IsValid(error) && limits.IsValid(error);
}

CertifiedScene PrepareCertifiedScene(const PreparedScene& scene,
                                     const SceneMeshes& meshes,
                                     const CertifiedContactOptions& options,
                                     const PreRotationOptions& pre_rotation,
                                     const MuscleSolver& solver,
                                     const ProgressCallback& on_progress) {
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  const Stopwatch preparing;
  CertifiedScene certified;
  certified.options = options;
  certified.order = OrderOfNames(scene);
  const std::vector<ExemptArea> exempt = ExemptInOrder(scene, certified.order);
  AddSurfaces(scene, exempt, &certified);
  std::vector<const SearchableMesh*> muscles, bones;
  for (const int i : certified.order) {
    muscles.push_back(meshes.muscles()[i].mesh);
  }
  for (const NamedMesh& bone : meshes.bones()) bones.push_back(bone.mesh);
  InitialSeparation separation =
      SeparateInitially(muscles,
                        bones,
                        exempt,
                        options.separation,
                        [&](int round, int /*crossing_pairs*/) {
                          if (on_progress)
                            on_progress({"separating", round, 0});
                        });

  const Mover mover = {scene, certified, pre_rotation, solver};
  SceneState rest = RestState(scene);
  for (const MuscleState& muscle : rest.muscles) {
    rest.free_coarse.push_back(muscle.coarse);
  }
  Place place = PlaceOf(mover, rest);
  place.surfaces.points = std::move(separation.points);
  WalkOptions walk;
  walk.step = options.step;
  walk.step.sweeps = options.rest_sweeps;
  walk.reach_growth = options.reach_growth;
  walk.max_reach = options.max_rest_reach;
  walk.max_settling_steps = options.max_rest_steps;
  walk.settling_tolerance = options.rest_tolerance;
  walk.accepts_self_crossings = true;
  Walk(mover, walk, rest.pose, /*at=*/1, on_progress, &place);
  certified.rest = StateOf(mover, place);
  certified.wall_ms = preparing.Milliseconds();
  return certified;
}

CertifiedMotion MoveCertified(const PreparedScene& scene,
                              const CertifiedScene& certified,
                              const ScenePose& pose,
                              const PreRotationOptions& pre_rotation,
                              const MuscleSolver& solver,
                              const SceneState& before,
                              const ProgressCallback& on_progress) {
  const Mover mover = {scene, certified, pre_rotation, solver};
  const CertifiedContactOptions& options = certified.options;
  WalkOptions walk;
  walk.step = options.step;
  walk.longest_step =
      1.0 / StepsBetween(scene.scene, before.pose, pose, options.limits);
  walk.max_halvings = options.max_halvings;
  walk.max_reach = options.step.reach;
  Place place = PlaceOf(mover, before);
  CertifiedMotion motion;
  motion.summary.steps = Walk(mover, walk, pose, /*at=*/0, on_progress, &place);
  motion.state = StateOf(mover, place);
  motion.summary.summaries = std::move(place.solved.summaries);
  return motion;
}

}  // namespace musclewarp
