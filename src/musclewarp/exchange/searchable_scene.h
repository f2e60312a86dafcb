// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "musclewarp/certificate/scene_intersections.h"
#include "musclewarp/run/recorded_pose.h"

namespace musclewarp {

// Meshes that can be searched, with their names.
struct SearchableScene {
  std::vector<std::unique_ptr<SearchableMesh>> meshes;
  std::vector<NamedMesh> muscles, bones;

  // Adds a mesh to `kind`, one of the two lists.
  void Add(const std::string& name,
           TriangleSoup soup,
           std::vector<NamedMesh>* kind);
};

// Returns the meshes of a pose.
SearchableScene SceneOf(const RecordedNames& names, const RecordedPose& pose);

}  // namespace musclewarp
