// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/scene_meshes.h"

#include <glog/logging.h>

#include <utility>

#include "musclewarp/base/parallel_for.h"
#include "musclewarp/base/stage_times.h"
#include "musclewarp/solver/muscle_course.h"

namespace musclewarp {

SceneMeshes::SceneMeshes(const PreparedScene& scene) {
  std::vector<TriangleSoup> soups;
  for (const PreparedMuscle& muscle : scene.muscles) {
    const MuscleModel& model = muscle.model;
    soups.push_back({model.fine_rest, model.fine_triangles});
    muscles_.push_back({model.name});
  }
  for (const PreparedBone& bone : scene.bones) {
    bones_.push_back({bone.mesh.name});
  }
  meshes_.resize(muscles_.size() + bones_.size());
  clusters_.resize(meshes_.size());
  rings_.resize(muscles_.size());
  rest_.resize(muscles_.size());
  ParallelFor(meshes_.size(), [&](size_t i) {
    const bool is_muscle = i < muscles_.size();
    NamedMesh& named = is_muscle ? muscles_[i] : bones_[i - muscles_.size()];
    if (is_muscle) {
      const TriangleSoup& soup = soups[i];
      clusters_[i] =
          std::make_shared<TriangleClusters>(soup.points, soup.triangles);
      rings_[i] =
          std::make_unique<VertexRings>(soup.triangles, soup.points.rows());
      named.rings = rings_[i].get();
      rest_[i] = std::make_unique<SurfaceAtRest>(
          soup.points, soup.triangles, CourseOf(scene.muscles[i].model));
      meshes_[i] = std::make_unique<SearchableMesh>(std::move(soups[i]));
    } else {
      const auto trees = TreesOf(scene.bones[i - muscles_.size()]);
      clusters_[i] = {trees, &trees->clusters};
      meshes_[i] = std::make_unique<SearchableMesh>(trees->mesh);
    }
    named.clusters = clusters_[i].get();
    named.mesh = meshes_[i].get();
  });
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
