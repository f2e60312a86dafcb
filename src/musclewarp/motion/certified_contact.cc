// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/certified_contact.h"

#include <glog/logging.h>

#include <algorithm>

#include "musclewarp/base/stopwatch.h"
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

ContactState ContactStateOf(const PreparedScene& scene,
                            const SceneState& state) {
  ContactState contact;
  contact.points.resize(scene.muscles.size());
  contact.targets.resize(scene.muscles.size());
#pragma omp parallel for schedule(dynamic, 1)
  for (size_t i = 0; i < scene.muscles.size(); ++i) {
    const MuscleModel& model = scene.muscles[i].model;
    const MuscleState& muscle = state.muscles[i];
    contact.targets[i] = FinePoints(model, {muscle.coarse, {}});
    contact.points[i] = contact.targets[i];
    if (muscle.contact.fine_offset.rows() > 0) {
      contact.points[i] += muscle.contact.fine_offset;
    }
  }
  for (const PreparedBone& bone : scene.bones) {
    contact.bones_from_rest.push_back(BodyTransform(state.pose, bone.body));
  }
  return contact;
}

void SetOffsets(const ContactState& contact, SceneState* state) {
  for (size_t i = 0; i < contact.points.size(); ++i) {
    state->muscles[i].contact.fine_offset =
        contact.points[i] - contact.targets[i];
  }
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
      !(max_rest_reach > 0 && rest_tolerance > 0 && max_turn > 0 &&
        max_move > 0)) {
    *error =
        "CertifiedContactOptions: rest_sweeps, max_rest_reach, "
        "rest_tolerance, max_turn and max_move must be above 0, "
        "max_rest_steps and max_halvings not below";
    return false;
  }
  return step.IsValid(error);
}

CertifiedContact PrepareCertifiedContact(
    const PreparedScene& scene, const CertifiedContactOptions& options) {
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  const Stopwatch preparing;
  CertifiedContact contact;
  contact.options = options;
  contact.rest.pose = RestPose(scene.scene);
  for (const PreparedMuscle& muscle : scene.muscles) {
    contact.muscles.push_back(ContactMesh::Of(muscle.model.fine_rest,
                                              muscle.model.fine_triangles,
                                              muscle.model.rest_volume));
    contact.rest.muscles.push_back({muscle.model.coarse_rest, {}});
  }
  for (const PreparedBone& bone : scene.bones) {
    contact.bones.push_back(
        std::make_unique<TriangleBvh>(bone.rest.points, bone.rest.triangles));
  }
  for (const ExemptArea& area : scene.exempt) {
    auto& of_muscle = contact.muscles[area.muscle].exempt;
    of_muscle.resize(scene.bones.size());
    of_muscle[area.bone] = area.triangles;
  }
  const SceneMeshes meshes(scene);
  const auto all = [](const std::vector<NamedMesh>& named) {
    std::vector<const SearchableMesh*> list;
    for (const NamedMesh& mesh : named) list.push_back(mesh.mesh);
    return list;
  };
  InitialSeparation separation = SeparateInitially(all(meshes.muscles()),
                                                   all(meshes.bones()),
                                                   scene.exempt,
                                                   options.separation);
  contact.separation_rounds = separation.rounds;
  contact.crossing_pairs = separation.crossing_pairs;
  ContactState state = ContactStateOf(scene, contact.rest);
  state.points = std::move(separation.points);
  const std::vector<const TriangleBvh*> bones = BoneTrees(contact);
  CleanStepOptions step_options = options.step;
  step_options.relaxation.sweeps = options.rest_sweeps;
  double& reach = step_options.relaxation.reach;
  for (int step = 0; step < options.max_rest_steps; ++step) {
    ContactState next = state;
    const std::vector<Points> before = state.points;
    const CleanStepSummary summary =
        StepCleanly(step_options, contact.muscles, bones, &next, &state);
    contact.crossing_pairs = summary.crossing_pairs;
    if (summary.crossing_pairs > 0) {
      if (reach >= options.max_rest_reach) break;
      reach = std::min(kWiderReach * reach, options.max_rest_reach);
      continue;
    }
    reach = options.step.relaxation.reach;
    if (!summary.is_clean) state = next;
    if (LargestMove(before, state.points) < options.rest_tolerance) break;
  }
  SetOffsets(state, &contact.rest);
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
  ContactState current = ContactStateOf(scene, *state);
  CertifiedWay way;
  way.is_clean = true;
  double at = 0, step = longest;
  while (at < 1) {
    // Rounding must not leave a last step of nothing.
    const double to = at + 1.01 * step >= 1 ? 1 : at + step;
    const ScenePose next_pose =
        to == 1 ? pose : PoseBetween(scene.scene, from, pose, to);
    SolvedPose solved =
        SolvePose(scene, nullptr, next_pose, pre_rotation, solver, state);
    SceneState reached;
    reached.pose = next_pose;
    for (const MuscleState& muscle : solved.states) {
      reached.muscles.push_back({muscle.coarse, {}});
    }
    ContactState next = ContactStateOf(scene, reached);
    const CleanStepSummary summary = StepCleanly(
        contact.options.step, contact.muscles, bones, &next, &current);
    ++way.steps;
    way.rounds += summary.rounds;
    const bool is_shortest = step <= shortest * 1.01;
    if (!summary.is_clean && !is_shortest) {
      step /= 2;
      continue;
    }
    if (!summary.is_clean) {
      // Nothing crosses, but some are nearer to each other than they should
      // be; or there is no way, and what follows may find out again.
      current = next;
      way.is_clean = way.is_clean && summary.crossing_pairs == 0;
    } else {
      step = std::min(longest, 2 * step);
    }
    SetOffsets(current, &reached);
    *state = std::move(reached);
    at = to;
    way.solved.solve_ms += solved.solve_ms;
    way.solved.states = state->muscles;
    way.solved.summaries = std::move(solved.summaries);
  }
  return way;
}

}  // namespace musclewarp
