// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frame_solvers/certified_frame_solver.h"

#include <algorithm>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "musclewarp/base/stage_times.h"
#include "musclewarp/base/stopwatch.h"
#include "musclewarp/certificate/push_chains.h"
#include "musclewarp/certificate/shortcomings.h"
#include "musclewarp/frames/frame_measures.h"
#include "musclewarp/frames/moment_arms.h"

namespace musclewarp {

CertifiedFrameSolver::CertifiedFrameSolver(const PreparedScene& scene,
                                           const FrameSolverOptions& options,
                                           const MuscleSolvers& solvers,
                                           std::shared_ptr<SceneMeshes> meshes,
                                           const ProgressCallback& on_progress,
                                           std::optional<SeparatedRest> rest)
    : FrameSolver(scene, options, std::move(meshes)) {
  if (rest) {
    certified_ = RestoreCertifiedScene(
        scene, *meshes_, options.certified, std::move(rest->state));
    contact_.rest = std::move(rest->intersections);
    contact_.displaced_at_rest = std::move(rest->displaced);
  } else {
    RestFrame();  // moves the meshes to rest
    certified_ = PrepareCertifiedScene(scene,
                                       *meshes_,
                                       options.certified,
                                       options.pre_rotation,
                                       solvers.single,
                                       on_progress);
    contact_.rest = IntersectAtRest(
        scene, ShapesOf(certified_, certified_.rest).fine, meshes_.get());
    contact_.displaced_at_rest = DisplacedAtRest();
  }
  contact_.options = {{"gap_mm", options.certified.step.gap}};
  contact_.prepare_ms = certified_.wall_ms;
}

std::optional<SeparatedRest> CertifiedFrameSolver::separated_rest() const {
  return SeparatedRest{
      certified_.rest, *contact_.rest, contact_.displaced_at_rest};
}

std::vector<int> CertifiedFrameSolver::DisplacedAtRest() {
  Frame rest;
  MuscleShapes shapes = ShapesOf(certified_, certified_.rest);
  rest.intersections = *contact_.rest;
  rest.bones = RestFrame().bones;
  for (size_t i = 0; i < scene_.muscles.size(); ++i) {
    MuscleFrame& muscle = rest.muscles.emplace_back();
    muscle.name = scene_.muscles[i].model.name;
    muscle.points = std::move(shapes.fine[i]);
  }
  MeasureContact(certified_.rest, &rest);
  std::vector<int> displaced;
  for (size_t i = 0; i < rest.muscles.size(); ++i) {
    if (rest.muscles[i].max_contact_displacement >
        LargestDisplacement(options_.requirements,
                            MeasuresOf(rest.muscles[i], i))) {
      displaced.push_back(static_cast<int>(i));
    }
  }
  return displaced;
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
                      {options.unchecked_share * options.limits.max_turn,
                       options.unchecked_share * options.limits.max_move});
}

SolvedFrame CertifiedFrameSolver::Solve(const MuscleSolvers& solvers,
                                        const ScenePose& pose,
                                        const SceneState* before,
                                        const ProgressCallback& on_progress) {
  const Stopwatch moving;
  const ContactState& from = before ? *before->contact : certified_.rest;
  CertifiedMotion motion = MoveCertified(scene_,
                                         certified_,
                                         pose,
                                         options_.pre_rotation,
                                         solvers.single,
                                         from,
                                         on_progress);
  const double wall_ms = moving.Milliseconds();
  const Stopwatch certifying;
  const MuscleShapes shapes = ShapesOf(certified_, motion.state);
  SolvedFrame result;
  result.frame = MeasureFrame(
      scene_,
      pose,
      shapes,
      before ? ShapesOf(certified_, from).fine : std::vector<Points>(),
      std::move(motion.summary.summaries),
      meshes_.get());
  MeasureDrift(motion.state, &result.frame);
  MeasureContact(motion.state, &result.frame);
  Judge(&result.frame);
  AddBoneOverlaps(&result.frame);
  if (motion.summary.timed_out_at) {
    std::ostringstream text;
    text << "the time ran out after " << static_cast<int>(wall_ms / 1000)
         << " s, at " << static_cast<int>(100 * *motion.summary.timed_out_at)
         << " % of the way; the rest was gone without contact";
    result.frame.shortcomings.insert(result.frame.shortcomings.begin(),
                                     text.str());
  }
  result.frame.pose_steps = motion.summary.steps;
  result.frame.wall_ms = wall_ms;
  result.frame.solve_ms = wall_ms;
  result.frame.certify_ms = certifying.Milliseconds();
  AddMomentArms(scene_,
                pose,
                options_.pre_rotation,
                {shapes.coarse,
                 ContactRowsOf(certified_, motion.state),
                 FreeCoarseOf(certified_, motion.state)},
                &result.frame);
  ContactState& next = motion.last_clean ? *motion.last_clean : motion.state;
  result.state.pose = next.pose;
  result.state.contact = std::move(next);
  return result;
}

std::vector<std::pair<int, int>> CertifiedFrameSolver::TouchingMuscles(
    const Frame& frame) const {
  std::map<std::string, int> numbers;
  for (size_t i = 0; i < frame.muscles.size(); ++i) {
    numbers[frame.muscles[i].name] = static_cast<int>(i);
  }
  std::vector<std::pair<int, int>> touching;
  for (const auto& gap : frame.intersections.gaps) {
    if (gap.at_least_mm > options_.requirements.touching_distance) continue;
    const auto a = numbers.find(gap.a), b = numbers.find(gap.b);
    if (a == numbers.end() || b == numbers.end()) continue;
    touching.emplace_back(a->second, b->second);
  }
  return touching;
}

std::vector<Points> CertifiedFrameSolver::MeshesWithoutContact(
    const ContactState& state) const {
  std::vector<Points> meshes(scene_.muscles.size());
#pragma omp parallel for schedule(dynamic, 1)
  for (size_t k = 0; k < certified_.order.size(); ++k) {
    const AttachedPoints& held = state.held[k];
    Points& points = meshes[certified_.order[k]];
    points =
        FinePoints(certified_.muscles[k]->model, {state.free_coarse[k], {}});
    points += certified_.extensions[k]->Extended(
        held.positions - Points(points(held.vertices, Eigen::all)));
  }
  return meshes;
}

void CertifiedFrameSolver::MeasureDrift(const ContactState& state,
                                        Frame* frame) const {
  for (size_t k = 0; k < certified_.order.size(); ++k) {
    const PreparedMuscle& muscle = *certified_.muscles[k];
    MuscleFrame& measured = frame->muscles[certified_.order[k]];
    measured.attachments = DriftOf(muscle.model.attachments,
                                   muscle.attached,
                                   state.held[k].positions,
                                   measured.points);
  }
}

void CertifiedFrameSolver::AddBoneOverlaps(Frame* frame) const {
  const auto leaves_a_bone = [](const MuscleFrame& muscle) {
    return std::any_of(
        muscle.attachments.begin(),
        muscle.attachments.end(),
        [](const AttachmentDrift& drift) { return drift.max > kLargestDrift; });
  };
  if (frame->shortcomings.empty() &&
      std::none_of(
          frame->muscles.begin(), frame->muscles.end(), leaves_a_bone)) {
    return;
  }
  std::vector<std::string> bodies;
  for (const PreparedBone& bone : scene_.bones) bodies.push_back(bone.body);
  frame->bone_overlaps = BoneOverlaps(meshes_->bones(), bodies);
}

void CertifiedFrameSolver::MeasureContact(const ContactState& state,
                                          Frame* frame) {
  const ScopedStage stage("displacement by contact");
  const std::vector<Points> without_contact = MeshesWithoutContact(state);
  meshes_->MoveTo(without_contact, frame->bones);
  const std::vector<PairDepth> overlaps =
      PenetrationDepths(meshes_->muscles(), meshes_->bones());
  const std::vector<PushChain> pushes =
      FarthestPushes(static_cast<int>(frame->muscles.size()),
                     overlaps,
                     TouchingMuscles(*frame));
  for (size_t i = 0; i < frame->muscles.size(); ++i) {
    MuscleFrame& muscle = frame->muscles[i];
    const Eigen::VectorXd moves =
        (muscle.points - without_contact[i]).rowwise().norm();
    muscle.max_contact_displacement = moves.maxCoeff();
    muscle.mean_contact_displacement = moves.mean();
    for (const PairDepth& overlap : overlaps) {
      const int muscle_number = static_cast<int>(i);
      if (overlap.a == muscle_number ||
          (!overlap.is_bone && overlap.b == muscle_number)) {
        muscle.depth_without_contact =
            std::max(muscle.depth_without_contact, overlap.depth);
      }
    }
    muscle.push_depth = pushes[i].depth;
    for (const int other : pushes[i].muscles) {
      muscle.pushed_by.push_back(frame->muscles[other].name);
    }
  }
}

MuscleMeasures CertifiedFrameSolver::MeasuresOf(const MuscleFrame& muscle,
                                                size_t number) const {
  MuscleMeasures measures = MuscleMeasuresOf(scene_.muscles[number], muscle);
  measures.num_triangles =
      static_cast<int>(scene_.muscles[number].model.fine_triangles.rows());
  measures.folded_triangles = muscle.folded_triangles;
  measures.self_pairs = muscle.self_pairs;
  measures.max_contact_displacement = muscle.max_contact_displacement;
  measures.depth_without_contact = muscle.depth_without_contact;
  measures.push_depth = muscle.push_depth;
  measures.pushed_by = muscle.pushed_by;
  return measures;
}

void CertifiedFrameSolver::Judge(Frame* frame) {
  std::vector<MuscleMeasures> measures;
  for (size_t i = 0; i < frame->muscles.size(); ++i) {
    measures.push_back(MeasuresOf(frame->muscles[i], i));
  }
  FrameRequirements requirements = options_.requirements;
  requirements.gap = std::max(requirements.gap, options_.certified.step.gap);
  frame->shortcomings =
      Shortcomings(requirements, frame->intersections, measures);
}

}  // namespace musclewarp
