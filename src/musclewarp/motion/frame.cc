// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/frame.h"

#include <glog/logging.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "musclewarp/base/stopwatch.h"
#include "musclewarp/geometry/folded_triangles.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/scene/line_targets.h"
#include "musclewarp/scene/path_moment_arms.h"

namespace musclewarp {
namespace {

MuscleFrame FrameOf(const PreparedMuscle& muscle,
                    const ScenePose& pose,
                    const MuscleState& state,
                    SolverSummary summary) {
  const MuscleModel& model = muscle.model;
  MuscleFrame frame;
  frame.solver = std::move(summary);
  frame.fine = FinePoints(model, state);
  frame.volume_ratio =
      SignedVolume(frame.fine, model.fine_triangles) / model.rest_volume;
  frame.max_displacement =
      (frame.fine - model.fine_rest).rowwise().norm().maxCoeff();
  frame.folded_triangles = static_cast<int>(
      FoldedTriangles(model.fine_rest, frame.fine, model.fine_triangles)
          .size());
  frame.lines = LinesAt(muscle.lines, state.coarse);
  frame.fibres = LinesAt(muscle.fibres, state.coarse);
  for (const ActionLine& line : model.lines) {
    frame.path_lengths.push_back(PathLengthIn(pose, line));
  }
  return frame;
}

std::vector<Points> RestBones(const PreparedScene& scene) {
  std::vector<Points> bones;
  for (const auto& bone : scene.bones) bones.push_back(bone.rest.points);
  return bones;
}

// Counts intersections and measures gaps.
void Certify(const PreparedScene& scene, SceneMeshes* meshes, Frame* frame) {
  std::vector<Points> muscles;
  for (const MuscleFrame& muscle : frame->muscles) {
    muscles.push_back(muscle.fine);
  }
  meshes->MoveTo(muscles, frame->bones);
  frame->intersections =
      IntersectScene(meshes->muscles(), meshes->bones(), scene.exempt);
  for (size_t i = 0; i < frame->muscles.size(); ++i) {
    frame->muscles[i].self_pairs =
        frame->intersections.self_pairs_of_muscles[i];
    frame->muscles[i].gaps =
        VertexGaps(i,
                   meshes->muscles(),
                   meshes->bones(),
                   frame->intersections.inside_of_muscles[i],
                   kGapLimit);
  }
}

// What the next pose starts from. Offsets of the fine vertices are part of it
// where contact acts on them; else they are a last correction, made anew.
SceneState StateOf(const ScenePose& pose,
                   const SceneContact* contact,
                   const std::vector<MuscleState>& states) {
  const bool keeps_offset =
      contact && contact->options.group.level == ContactLevel::kFine;
  SceneState state;
  state.pose = pose;
  for (const MuscleState& muscle : states) {
    MuscleState kept;
    kept.coarse = muscle.coarse;
    if (keeps_offset)
      kept.corrections.fine_offset = muscle.corrections.fine_offset;
    state.muscles.push_back(std::move(kept));
  }
  return state;
}

double TurnBetween(const Eigen::Matrix4d& from, const Eigen::Matrix4d& to) {
  const Eigen::Matrix3d turn =
      to.topLeftCorner<3, 3>() * from.topLeftCorner<3, 3>().transpose();
  return std::acos(std::clamp((turn.trace() - 1) / 2, -1.0, 1.0));
}

}  // namespace

int Frame::iterations() const {
  int sum = 0;
  for (const MuscleFrame& muscle : muscles) sum += muscle.solver.iterations;
  return sum;
}

std::string Frame::stop_reason(const PreparedScene& scene) const {
  for (size_t i = 0; i < muscles.size(); ++i) {
    if (muscles[i].solver.stop_reason == StopReason::kConverged) continue;
    return ToString(muscles[i].solver.stop_reason) + " (" +
           scene.muscles[i].model.name + ")";
  }
  return ToString(StopReason::kConverged);
}

bool Frame::IsUsable() const {
  if (!shortcomings.empty()) return false;
  for (const MuscleFrame& muscle : muscles) {
    if (!muscle.solver.IsSolutionUsable()) return false;
  }
  return true;
}

bool FrameOptions::IsValid(std::string* error) const {
  if (max_turn > 0 && max_move > 0) return true;
  *error = "FrameOptions::max_turn and max_move must be above 0";
  return false;
}

int StepsBetween(const Scene& scene,
                 const ScenePose& from,
                 const ScenePose& to,
                 const FrameOptions& options) {
  double steps = 1;
  for (const SceneBone& bone : scene.bones) {
    const double turn = TurnBetween(BodyTransform(from, bone.body),
                                    BodyTransform(to, bone.body));
    steps = std::max(steps, turn / options.max_turn);
  }
  for (const SceneMuscle& muscle : scene.muscles) {
    const auto targets_0 = LineTargets(muscle.lines, from);
    const auto targets_1 = LineTargets(muscle.lines, to);
    for (size_t i = 0; i < targets_0.size(); ++i) {
      const double move = (targets_1[i].points - targets_0[i].points)
                              .rowwise()
                              .norm()
                              .maxCoeff();
      steps = std::max(steps, move / options.max_move);
    }
  }
  return static_cast<int>(std::ceil(steps));
}

Frame SolveFrame(const PreparedScene& scene,
                 const SceneContact* contact,
                 int index,
                 const FrameOptions& options,
                 const GroupSolver& solver,
                 SceneMeshes* meshes,
                 SceneState* state) {
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  const Stopwatch moving;
  Frame frame;
  frame.index = index;
  frame.pose = &scene.scene.poses[index];
  const ScenePose& pose = *frame.pose;
  const auto solve = [&](const ScenePose& target) {
    SolvedPose solved =
        SolvePose(scene, contact, target, options.pre_rotation, solver, state);
    frame.solve_ms += solved.solve_ms;
    return solved;
  };
  // Without contact the result does not depend on the way.
  if (state && contact) {
    const ScenePose from = state->pose;
    frame.pose_steps = StepsBetween(scene.scene, from, pose, options);
    for (int i = 1; i < frame.pose_steps; ++i) {
      const ScenePose between = PoseBetween(
          scene.scene, from, pose, static_cast<double>(i) / frame.pose_steps);
      *state = StateOf(between, contact, solve(between).states);
    }
  }
  SolvedPose solved = solve(pose);
  if (state) *state = StateOf(pose, contact, solved.states);
  frame.wall_ms = moving.Milliseconds();
  const Stopwatch certifying;
  MeasureFrame(
      scene, pose, solved.states, std::move(solved.summaries), meshes, &frame);
  frame.certify_ms = certifying.Milliseconds();
  return frame;
}

void MeasureFrame(const PreparedScene& scene,
                  const ScenePose& pose,
                  const std::vector<MuscleState>& states,
                  std::vector<SolverSummary> summaries,
                  SceneMeshes* meshes,
                  Frame* frame) {
  frame->muscles.resize(scene.muscles.size());
#pragma omp parallel for schedule(dynamic, 1)
  for (size_t i = 0; i < scene.muscles.size(); ++i) {
    frame->muscles[i] =
        FrameOf(scene.muscles[i], pose, states[i], std::move(summaries[i]));
  }
  frame->bones = BonesIn(scene, pose);
  frame->path_moment_arms = PathMomentArms(scene.scene, pose);
  Certify(scene, meshes, frame);
}

std::vector<Points> BonesIn(const PreparedScene& scene, const ScenePose& pose) {
  std::vector<Points> bones;
  for (const PreparedBone& bone : scene.bones) {
    bones.push_back(
        Transformed(bone.rest.points, BodyTransform(pose, bone.body)));
  }
  return bones;
}

SceneState StartState(const PreparedScene& scene,
                      const SceneContact* contact,
                      const FrameOptions& options,
                      const GroupSolver& solver) {
  const ScenePose rest = RestPose(scene.scene);
  if (contact) {
    return StateOf(
        rest,
        contact,
        SolvePose(scene, contact, rest, options.pre_rotation, solver, nullptr)
            .states);
  }
  SceneState state;
  state.pose = rest;
  for (const PreparedMuscle& muscle : scene.muscles) {
    state.muscles.push_back({muscle.model.coarse_rest, {}});
  }
  return state;
}

Frame RestFrame(const PreparedScene& scene, SceneMeshes* meshes) {
  Frame frame;
  frame.index = -1;
  for (const PreparedMuscle& muscle : scene.muscles) {
    MuscleFrame at_rest;
    at_rest.fine = muscle.model.fine_rest;
    at_rest.volume_ratio = 1;
    at_rest.lines = LinesAt(muscle.lines, muscle.model.coarse_rest);
    at_rest.fibres = LinesAt(muscle.fibres, muscle.model.coarse_rest);
    frame.muscles.push_back(std::move(at_rest));
  }
  frame.bones = RestBones(scene);
  Certify(scene, meshes, &frame);
  return frame;
}

SceneIntersections RestIntersectionsAfterFix(const PreparedScene& scene,
                                             const SceneContact& contact,
                                             SceneMeshes* meshes) {
  GroupContact group_contact = ContactInPose(scene, contact, ScenePose());
  std::vector<MuscleState> states;
  for (const auto& muscle : scene.muscles) {
    states.push_back({muscle.model.coarse_rest, {}});
  }
  group_contact.Start(&states);
  std::vector<Points> muscles;
  for (size_t i = 0; i < states.size(); ++i) {
    muscles.push_back(FinePoints(scene.muscles[i].model, states[i]));
  }
  meshes->MoveTo(muscles, RestBones(scene));
  return IntersectScene(meshes->muscles(), meshes->bones(), scene.exempt);
}

}  // namespace musclewarp
