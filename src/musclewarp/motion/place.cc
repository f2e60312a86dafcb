// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/place.h"

#include "musclewarp/scene/line_targets.h"

namespace musclewarp {
namespace {

std::vector<MuscleState> WithoutOffsets(
    const std::vector<MuscleState>& muscles) {
  std::vector<MuscleState> coarse;
  for (const MuscleState& muscle : muscles) {
    coarse.push_back({muscle.coarse, {}});
  }
  return coarse;
}

}  // namespace

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

std::vector<Eigen::Matrix4d> BonesFromRest(const PreparedScene& scene,
                                           const ScenePose& pose) {
  std::vector<Eigen::Matrix4d> transforms;
  for (const PreparedBone& bone : scene.bones) {
    transforms.push_back(BodyTransform(pose, bone.body));
  }
  return transforms;
}

std::vector<AttachedPoints> AttachedIn(const Mover& mover,
                                       const ScenePose& pose) {
  const CertifiedScene& certified = mover.certified;
  std::vector<AttachedPoints> all;
  for (size_t k = 0; k < certified.attached_rest.size(); ++k) {
    const PreparedMuscle& muscle = mover.scene.muscles[certified.order[k]];
    all.push_back({muscle.attached.vertices,
                   AttachedPositions(muscle.model.attachments,
                                     muscle.attached,
                                     certified.attached_rest[k],
                                     pose)});
  }
  return all;
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

}  // namespace musclewarp
