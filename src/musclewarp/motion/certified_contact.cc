// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/certified_contact.h"

#include <glog/logging.h>

#include <algorithm>
#include <numeric>

#include "musclewarp/base/stopwatch.h"
#include "musclewarp/geometry/spread_points.h"
#include "musclewarp/motion/frame.h"
#include "musclewarp/scene/line_targets.h"

namespace musclewarp {
namespace {

// Of a step at rest that is tried again.
constexpr double kWiderReach = 1.5;

std::vector<const TriangleBvh*> BoneTrees(const CertifiedContact& contact) {
  std::vector<const TriangleBvh*> trees;
  for (const auto& bone : contact.bones) trees.push_back(bone.get());
  return trees;
}

std::vector<int> OrderOfNames(const PreparedScene& scene) {
  std::vector<int> order(scene.muscles.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return scene.muscles[a].model.name < scene.muscles[b].model.name;
  });
  return order;
}

// In the order of contact.
std::vector<Points> FineMeshes(const PreparedScene& scene,
                               const std::vector<int>& order,
                               const std::vector<MuscleState>& muscles) {
  std::vector<Points> meshes(order.size());
#pragma omp parallel for schedule(dynamic, 1)
  for (size_t k = 0; k < order.size(); ++k) {
    meshes[k] = FinePoints(scene.muscles[order[k]].model, muscles[order[k]]);
  }
  return meshes;
}

std::vector<Eigen::Matrix4d> BonesFromRest(const PreparedScene& scene,
                                           const ScenePose& pose) {
  std::vector<Eigen::Matrix4d> transforms;
  for (const PreparedBone& bone : scene.bones) {
    transforms.push_back(BodyTransform(pose, bone.body));
  }
  return transforms;
}

// The state of a scene in `pose` of which the muscles are `free` without
// contact, the coarse meshes are where they are `solved` and the fine ones
// where `contact` has them.
SceneState StateOf(const ScenePose& pose,
                   const std::vector<int>& order,
                   const SolvedPose& free,
                   const SolvedPose& solved,
                   const ContactState& contact) {
  SceneState state;
  state.pose = pose;
  state.muscles = solved.states;
  for (const MuscleState& muscle : free.states) {
    state.free_coarse.push_back(muscle.coarse);
  }
  for (size_t k = 0; k < order.size(); ++k) {
    state.muscles[order[k]].corrections.fine_offset =
        contact.points[k] - contact.targets[k];
  }
  return state;
}

std::vector<MuscleState> CoarseAlone(const std::vector<MuscleState>& muscles) {
  std::vector<MuscleState> coarse;
  for (const MuscleState& muscle : muscles) {
    coarse.push_back({muscle.coarse, {}});
  }
  return coarse;
}

SceneState WithoutContact(const SceneState& state) {
  SceneState free;
  free.pose = state.pose;
  for (const Points& coarse : state.free_coarse) {
    free.muscles.push_back({coarse, {}});
  }
  return free;
}

// Solves the muscles of a pose, which are `free` without contact, for the
// planes of a relaxation. `solved` is start and result.
CoarseContact CoarseContactIn(const PreparedScene& scene,
                              const CertifiedContact& contact,
                              const ScenePose& pose,
                              const PreRotationOptions& pre_rotation,
                              const GroupSolver& solver,
                              const SolvedPose& free,
                              SolvedPose* solved) {
  const double weight = contact.options.coarse_weight;
  if (weight == 0) return nullptr;
  return [=, &scene, &contact, &pose, &solver, &free](
             const ContactRelaxation& relaxation) {
    std::vector<OneSidedRows> rows(scene.muscles.size());
    for (size_t k = 0; k < contact.order.size(); ++k) {
      rows[contact.order[k]] = OneSidedRowsOf(
          relaxation.TightestPlanes(static_cast<int>(k), contact.samples[k]),
          weight);
    }
    *solved = SolveWithContactRows(scene,
                                   free,
                                   pose,
                                   pre_rotation,
                                   solver,
                                   std::move(rows),
                                   std::move(solved->states));
    return FineMeshes(scene, contact.order, solved->states);
  };
}

double LargestMove(const std::vector<Points>& a, const std::vector<Points>& b) {
  double most = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    most = std::max(most, (a[i] - b[i]).rowwise().norm().maxCoeff());
  }
  return most;
}

}  // namespace

bool CertifiedContactOptions::IsValid(std::string* error) const {
  if (max_rest_steps < 0 || rest_sweeps < 1 || max_halvings < 0 ||
      !(samples_per_coarse_vertex > 0 && coarse_weight >= 0 &&
        max_rest_reach > 0 && rest_tolerance > 0 && max_turn > 0 &&
        max_move > 0)) {
    *error =
        "CertifiedContactOptions: samples_per_coarse_vertex, rest_sweeps, "
        "max_rest_reach, rest_tolerance, max_turn and max_move must be above "
        "0, "
        "coarse_weight, max_rest_steps and max_halvings not below";
    return false;
  }
  return step.IsValid(error);
}

CertifiedContact PrepareCertifiedContact(const PreparedScene& scene,
                                         const CertifiedContactOptions& options,
                                         const PreRotationOptions& pre_rotation,
                                         const GroupSolver& solver) {
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  const Stopwatch preparing;
  CertifiedContact contact;
  contact.options = options;
  contact.rest.pose = RestPose(scene.scene);
  contact.order = OrderOfNames(scene);
  for (const PreparedMuscle& muscle : scene.muscles) {
    contact.rest.muscles.push_back({muscle.model.coarse_rest, {}});
  }
  for (const int i : contact.order) {
    const MuscleModel& model = scene.muscles[i].model;
    contact.muscles.push_back(ContactMesh::Of(
        model.fine_rest, model.fine_triangles, model.rest_volume));
    contact.samples.push_back(SpreadPoints(
        model.fine_rest,
        static_cast<int>(options.samples_per_coarse_vertex *
                         static_cast<double>(model.coarse_rest.rows()))));
  }
  for (const PreparedBone& bone : scene.bones) {
    contact.bones.push_back(
        std::make_unique<TriangleBvh>(bone.rest.points, bone.rest.triangles));
  }
  std::vector<ExemptArea> exempt = scene.exempt;
  for (ExemptArea& area : exempt) {
    const auto place =
        std::find(contact.order.begin(), contact.order.end(), area.muscle);
    area.muscle = static_cast<int>(place - contact.order.begin());
    auto& of_muscle = contact.muscles[area.muscle].exempt;
    of_muscle.resize(scene.bones.size());
    of_muscle[area.bone] = area.triangles;
  }
  const SceneMeshes meshes(scene);
  std::vector<const SearchableMesh*> muscles, bones_at_rest;
  for (const int i : contact.order) {
    muscles.push_back(meshes.muscles()[i].mesh);
  }
  for (const NamedMesh& bone : meshes.bones()) {
    bones_at_rest.push_back(bone.mesh);
  }
  InitialSeparation separation =
      SeparateInitially(muscles, bones_at_rest, exempt, options.separation);
  ContactState state;
  state.points = std::move(separation.points);
  state.targets = FineMeshes(scene, contact.order, contact.rest.muscles);
  state.bones_from_rest = BonesFromRest(scene, contact.rest.pose);
  const std::vector<const TriangleBvh*> bones = BoneTrees(contact);
  CleanStepOptions step_options = options.step;
  step_options.relaxation.sweeps = options.rest_sweeps;
  double& reach = step_options.relaxation.reach;
  SolvedPose free;
  free.states = contact.rest.muscles;
  free.summaries.resize(scene.muscles.size());
  SolvedPose solved = free;
  for (int step = 0; step < options.max_rest_steps; ++step) {
    ContactState next = state;
    const std::vector<Points> before = state.points;
    SolvedPose tried = solved;
    const CleanStepSummary summary =
        StepCleanly(step_options,
                    contact.muscles,
                    bones,
                    CoarseContactIn(scene,
                                    contact,
                                    contact.rest.pose,
                                    pre_rotation,
                                    solver,
                                    free,
                                    &tried),
                    &next,
                    &state);
    if (summary.crossing_pairs > 0) {
      if (reach >= options.max_rest_reach) break;
      reach = std::min(kWiderReach * reach, options.max_rest_reach);
      continue;
    }
    reach = options.step.relaxation.reach;
    solved = std::move(tried);
    if (!summary.is_clean) state = next;
    if (LargestMove(before, state.points) < options.rest_tolerance) break;
  }
  contact.rest = StateOf(contact.rest.pose, contact.order, free, solved, state);
  contact.wall_ms = preparing.Milliseconds();
  return contact;
}

CertifiedWay MoveCertified(const PreparedScene& scene,
                           const CertifiedContact& contact,
                           const ScenePose& pose,
                           const PreRotationOptions& pre_rotation,
                           const GroupSolver& solver,
                           SceneState* state) {
  FrameOptions limits;
  limits.max_turn = contact.options.max_turn;
  limits.max_move = contact.options.max_move;
  const ScenePose from = state->pose;
  const double longest = 1.0 / StepsBetween(scene.scene, from, pose, limits);
  const double shortest = longest / (1 << contact.options.max_halvings);
  const std::vector<const TriangleBvh*> bones = BoneTrees(contact);
  ContactState current;
  current.targets =
      FineMeshes(scene, contact.order, CoarseAlone(state->muscles));
  current.points = current.targets;
  for (size_t k = 0; k < contact.order.size(); ++k) {
    current.points[k] +=
        state->muscles[contact.order[k]].corrections.fine_offset;
  }
  current.bones_from_rest = BonesFromRest(scene, state->pose);
  CertifiedWay way;
  double at = 0, step = longest;
  while (at < 1) {
    // Rounding must not leave a last step of nothing.
    const double to = at + 1.01 * step >= 1 ? 1 : at + step;
    const ScenePose next_pose =
        to == 1 ? pose : PoseBetween(scene.scene, from, pose, to);
    const SceneState before = WithoutContact(*state);
    const SolvedPose free =
        SolvePose(scene, nullptr, next_pose, pre_rotation, solver, &before);
    // What contact has moved the coarse meshes by goes along.
    SolvedPose solved = free;
    for (size_t i = 0; i < scene.muscles.size(); ++i) {
      solved.states[i].coarse +=
          state->muscles[i].coarse - before.muscles[i].coarse;
    }
    ContactState next;
    next.targets = FineMeshes(scene, contact.order, solved.states);
    next.bones_from_rest = BonesFromRest(scene, next_pose);
    const CoarseContact make_way = CoarseContactIn(
        scene, contact, next_pose, pre_rotation, solver, free, &solved);
    const CleanStepSummary summary = StepCleanly(contact.options.step,
                                                 contact.muscles,
                                                 bones,
                                                 make_way,
                                                 &next,
                                                 &current);
    ++way.steps;
    const bool is_shortest = step <= shortest * 1.01;
    if (!summary.is_clean && !is_shortest) {
      step /= 2;
      continue;
    }
    if (!summary.is_clean) {
      // Nothing crosses, but some are nearer to each other than they should
      // be; or there is no way, and what follows may find out again.
      current = next;
    } else {
      step = std::min(longest, 2 * step);
    }
    *state = StateOf(next_pose, contact.order, free, solved, current);
    way.summaries = std::move(solved.summaries);
    at = to;
  }
  return way;
}

}  // namespace musclewarp
