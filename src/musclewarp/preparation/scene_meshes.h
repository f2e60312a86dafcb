// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "musclewarp/certificate/scene_intersections.h"
#include "musclewarp/geometry/surface_deformation.h"
#include "musclewarp/preparation/prepared_scene.h"

namespace musclewarp {

// The meshes of a scene with the data needed to measure its frames: search
// trees for counting intersections, which are built once in the rest pose and
// refitted to the points of each frame in a fraction of the time, and the
// surfaces at rest.
class SceneMeshes {
 public:
  // Copies the meshes in their rest pose.
  explicit SceneMeshes(const PreparedScene& scene);

  // Moves all meshes to new points, in scene order, #V x 3 each, mm. Unmoved
  // meshes are not refitted.
  void MoveTo(const std::vector<Points>& muscles,
              const std::vector<Points>& bones);

  const std::vector<NamedMesh>& muscles() const { return muscles_; }
  const std::vector<NamedMesh>& bones() const { return bones_; }

  // The surface of a muscle in its rest pose, with its course (CourseOf).
  const SurfaceAtRest& rest_of_muscle(size_t i) const { return *rest_[i]; }

 private:
  std::vector<std::unique_ptr<SearchableMesh>> meshes_;  // muscles, then bones
  std::vector<std::shared_ptr<const TriangleClusters>> clusters_;
  std::vector<std::unique_ptr<VertexRings>> rings_;   // of the muscles
  std::vector<std::unique_ptr<SurfaceAtRest>> rest_;  // of the muscles
  std::vector<NamedMesh> muscles_, bones_;
};

}  // namespace musclewarp
