// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/scene_meshes.h"

#include <glog/logging.h>

#include "musclewarp/base/stage_times.h"

namespace musclewarp {

SceneMeshes::SceneMeshes(const PreparedScene& scene) {
  const auto add = [&](const std::string& name, const TriangleSoup& soup) {
    meshes_.push_back(std::make_unique<SearchableMesh>(soup));
    clusters_.push_back(
        std::make_unique<TriangleClusters>(soup.points, soup.triangles));
    return NamedMesh{
        name, meshes_.back().get(), nullptr, clusters_.back().get()};
  };
  for (const PreparedMuscle& muscle : scene.muscles) {
    const MuscleModel& model = muscle.model;
    muscles_.push_back(
        add(model.name, {model.fine_rest, model.fine_triangles}));
    rings_.push_back(std::make_unique<VertexRings>(model.fine_triangles,
                                                   model.fine_rest.rows()));
    muscles_.back().rings = rings_.back().get();
  }
  for (const PreparedBone& bone : scene.bones) {
    bones_.push_back(add(bone.mesh.name, bone.rest));
  }
}

void SceneMeshes::MoveTo(const std::vector<Points>& muscles,
                         const std::vector<Points>& bones) {
  const ScopedStage stage("trees of the certificate");
  CHECK_EQ(muscles.size(), muscles_.size());
  CHECK_EQ(bones.size(), bones_.size());
  const int count = static_cast<int>(meshes_.size());
#pragma omp parallel for schedule(dynamic)
  for (int i = 0; i < count; ++i) {
    const size_t bone = i - muscles.size();
    const Points& points =
        i < static_cast<int>(muscles.size()) ? muscles[i] : bones[bone];
    if (meshes_[i]->points() != points) meshes_[i]->Refit(points);
  }
}

}  // namespace musclewarp
