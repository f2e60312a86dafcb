// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/motion_context.h"

#include <utility>

#include "musclewarp/scene/line_targets.h"

namespace musclewarp {

std::vector<Points> FineMeshes(const CertifiedScene& certified,
                               const std::vector<Points>& coarse) {
  std::vector<Points> meshes(coarse.size());
#pragma omp parallel for schedule(dynamic, 1)
  for (size_t i = 0; i < coarse.size(); ++i) {
    meshes[i] = FinePoints(certified.muscles[i]->model, {coarse[i], {}});
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

std::vector<AttachedPoints> AttachedIn(const CertifiedScene& certified,
                                       const ScenePose& pose) {
  std::vector<AttachedPoints> all;
  for (size_t i = 0; i < certified.rest.held.size(); ++i) {
    const PreparedMuscle& muscle = *certified.muscles[i];
    all.push_back({muscle.attached.vertices,
                   AttachedPositions(muscle.model,
                                     muscle.attached,
                                     certified.rest.held[i].positions,
                                     pose)});
  }
  return all;
}

ContactState StateWithoutContact(const PreparedScene& scene,
                                 const CertifiedScene& certified,
                                 const ScenePose& pose,
                                 std::vector<Points> coarse) {
  ContactState state;
  state.pose = pose;
  state.bones_from_rest = BonesFromRest(scene, pose);
  state.free_coarse = coarse;
  state.coarse = std::move(coarse);
  state.targets = FineMeshes(certified, state.coarse);
  state.points = state.targets;
  return state;
}

}  // namespace musclewarp
