// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "musclewarp/certificate/scene_intersections.h"
#include "musclewarp/motion/prepared_scene.h"

namespace musclewarp {

// The meshes of a scene, searchable. Their trees are built once, in the rest
// pose, and follow the points from frame to frame.
class SceneMeshes {
 public:
  explicit SceneMeshes(const PreparedScene& scene);

  // Points in scene order, #V x 3 each. What has not moved costs nothing.
  void MoveTo(const std::vector<Points>& muscles,
              const std::vector<Points>& bones);

  const std::vector<NamedMesh>& muscles() const { return muscles_; }
  const std::vector<NamedMesh>& bones() const { return bones_; }

 private:
  std::vector<std::unique_ptr<SearchableMesh>> meshes_;  // muscles, then bones
  std::vector<NamedMesh> muscles_, bones_;
};

}  // namespace musclewarp
