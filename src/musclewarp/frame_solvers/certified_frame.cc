// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frame_solvers/certified_frame.h"

#include <algorithm>
#include <string>
#include <utility>

#include "musclewarp/base/stage_times.h"
#include "musclewarp/certificate/bone_overlaps.h"
#include "musclewarp/certificate/push_chains.h"
#include "musclewarp/frames/triangle_stretch.h"

namespace musclewarp {
namespace {

// Returns the pairs of muscles at most `touching_distance` (mm) apart.
std::vector<std::pair<int, int>> TouchingMuscles(
    const SceneIntersections& intersections, double touching_distance) {
  std::vector<std::pair<int, int>> touching;
  for (const MeshGap& gap : intersections.gaps) {
    if (gap.at_least_mm > touching_distance || gap.muscle_b < 0) continue;
    touching.emplace_back(gap.muscle_a, gap.muscle_b);
  }
  return touching;
}

// Returns the fine meshes of a state without contact, in the order of the
// scene: the solutions without contact, with offsets at their attachments.
std::vector<Points> MeshesWithoutContact(const CertifiedScene& certified,
                                         const ContactState& state) {
  std::vector<Points> meshes(certified.order.size());
#pragma omp parallel for schedule(dynamic, 1)
  for (size_t k = 0; k < certified.order.size(); ++k) {
    const AttachedPoints& held = state.held[k];
    Points& points = meshes[certified.order[k]];
    points =
        FinePoints(certified.muscles[k]->model, {state.free_coarse[k], {}});
    points += certified.extensions[k]->Extended(
        held.positions - Points(points(held.vertices, Eigen::all)));
  }
  return meshes;
}

// Measures the distances of attached vertices from their bodies.
void MeasureDrift(const CertifiedScene& certified,
                  const ContactState& state,
                  Frame* frame) {
  for (size_t k = 0; k < certified.order.size(); ++k) {
    const PreparedMuscle& muscle = *certified.muscles[k];
    MuscleFrame& measured = frame->muscles[certified.order[k]];
    measured.attachments = DriftOf(muscle.model.attachments,
                                   muscle.attached,
                                   state.held[k].positions,
                                   measured.points);
  }
}

// Measures what contact does to the muscles of a frame, relative to their
// shapes without contact.
void MeasureContact(const PreparedScene& scene,
                    const CertifiedScene& certified,
                    const ContactState& state,
                    double touching_distance,
                    SceneMeshes* meshes,
                    Frame* frame) {
  const ScopedStage stage("displacement by contact");
  const std::vector<Points> without_contact =
      MeshesWithoutContact(certified, state);
  meshes->MoveTo(without_contact, frame->bones);
  const std::vector<PairDepth> overlaps =
      PenetrationDepths(meshes->muscles(), meshes->bones());
  const std::vector<PushChain> pushes =
      FarthestPushes(static_cast<int>(frame->muscles.size()),
                     overlaps,
                     TouchingMuscles(frame->intersections, touching_distance));
  for (size_t i = 0; i < frame->muscles.size(); ++i) {
    MuscleFrame& muscle = frame->muscles[i];
    const Eigen::VectorXd moves =
        (muscle.points - without_contact[i]).rowwise().norm();
    muscle.max_contact_displacement = moves.maxCoeff();
    muscle.mean_contact_displacement = moves.mean();
    if (muscle.shape.triangles.largest_patch > 0) {
      const MuscleModel& model = scene.muscles[i].model;
      muscle.torn_patch = LargestTornPatch(model.fine_rest,
                                           muscle.points,
                                           without_contact[i],
                                           model.fine_triangles);
    }
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

// Lists the violated requirements as shortcomings of the frame.
void Judge(const PreparedScene& scene,
           const FrameRequirements& requirements,
           Frame* frame) {
  std::vector<JudgedMuscle> muscles;
  for (size_t i = 0; i < frame->muscles.size(); ++i) {
    muscles.push_back(JudgedMuscleOf(scene.muscles[i], frame->muscles[i]));
  }
  frame->shortcomings =
      Shortcomings(requirements, frame->intersections, muscles);
  for (std::string& shortcoming : DeliveredShortcomings(
           frame->delivered_crossings, requirements.body_size)) {
    frame->shortcomings.push_back(std::move(shortcoming));
  }
}

// Finds overlapping bones if the frame has shortcomings or drifting
// attachments, as they are a possible cause. Precondition: the meshes of the
// bones are in the pose of the frame.
void AddBoneOverlaps(const PreparedScene& scene,
                     const SceneMeshes& meshes,
                     Frame* frame) {
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
  for (const PreparedBone& bone : scene.bones) bodies.push_back(bone.body);
  frame->bone_overlaps = BoneOverlaps(meshes.bones(), bodies);
}

// Returns the indices of the muscles whose displacement by contact in the
// separated rest pose exceeds the requirements. `intersections`: those of the
// rest pose.
std::vector<int> MusclesDisplacedAtRest(const PreparedScene& scene,
                                        const CertifiedScene& certified,
                                        const FrameRequirements& requirements,
                                        const SceneIntersections& intersections,
                                        SceneMeshes* meshes) {
  Frame rest;
  MuscleShapes shapes = ShapesOf(certified, certified.rest);
  rest.intersections = intersections;
  for (const PreparedBone& bone : scene.bones) {
    rest.bones.push_back(bone.rest.points);
  }
  for (size_t i = 0; i < scene.muscles.size(); ++i) {
    MuscleFrame& muscle = rest.muscles.emplace_back();
    muscle.name = scene.muscles[i].model.name;
    muscle.points = std::move(shapes.fine[i]);
  }
  MeasureContact(scene,
                 certified,
                 certified.rest,
                 requirements.touching_distance,
                 meshes,
                 &rest);
  std::vector<int> displaced;
  for (size_t i = 0; i < rest.muscles.size(); ++i) {
    if (rest.muscles[i].max_contact_displacement >
        LargestDisplacement(requirements, rest.muscles[i])) {
      displaced.push_back(static_cast<int>(i));
    }
  }
  return displaced;
}

}  // namespace

Frame CertifiedFrame(const PreparedScene& scene,
                     const CertifiedScene& certified,
                     const FrameRequirements& requirements,
                     const ContactState& state,
                     const std::vector<Points>& before,
                     std::vector<SolverSummary> summaries,
                     SceneMeshes* meshes,
                     const MeasureOptions& options) {
  Frame frame = MeasureFrame(scene,
                             state.pose,
                             ShapesOf(certified, state),
                             before,
                             std::move(summaries),
                             meshes,
                             options);
  MeasureDrift(certified, state, &frame);
  MeasureContact(
      scene, certified, state, requirements.touching_distance, meshes, &frame);
  FrameRequirements with_gap = requirements;
  with_gap.gap = std::max(requirements.gap, certified.options.step.gap);
  with_gap.body_size = scene.scene.body_size;
  Judge(scene, with_gap, &frame);
  AddBoneOverlaps(scene, *meshes, &frame);
  return frame;
}

RestResult RestResultOf(const PreparedScene& scene,
                        CertifiedScene certified,
                        const FrameRequirements& requirements,
                        SceneMeshes* meshes) {
  RestResult result;
  result.intersections =
      IntersectAtRest(scene, ShapesOf(certified, certified.rest).fine, meshes);
  result.displaced = MusclesDisplacedAtRest(
      scene, certified, requirements, result.intersections, meshes);
  result.state = std::move(certified.rest);
  return result;
}

}  // namespace musclewarp
