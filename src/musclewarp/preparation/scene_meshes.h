// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "musclewarp/certificate/scene_intersections.h"
#include "musclewarp/preparation/prepared_scene.h"

namespace musclewarp {

// The meshes of a scene with search trees for counting intersections. The trees
// are built once, in the rest pose, and refitted to the points of each frame in
// a fraction of the time.
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

 private:
  std::vector<std::unique_ptr<SearchableMesh>> meshes_;  // muscles, then bones
  std::vector<std::unique_ptr<TriangleClusters>> clusters_;
  std::vector<std::unique_ptr<VertexRings>> rings_;  // of the muscles
  std::vector<NamedMesh> muscles_, bones_;
};

}  // namespace musclewarp
