// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/searchable_scene.h"

#include <utility>

namespace musclewarp {

void SearchableScene::Add(const std::string& name,
                          TriangleSoup soup,
                          std::vector<NamedMesh>* kind) {
  meshes.push_back(std::make_unique<SearchableMesh>(std::move(soup)));
  kind->push_back({name, meshes.back().get()});
}

SearchableScene SceneOf(const RecordedNames& names, const RecordedPose& pose) {
  SearchableScene scene;
  for (size_t i = 0; i < names.muscles.size(); ++i) {
    scene.Add(names.muscles[i], pose.muscles[i], &scene.muscles);
  }
  for (size_t i = 0; i < names.bones.size(); ++i) {
    scene.Add(names.bones[i], pose.bones[i], &scene.bones);
  }
  return scene;
}

}  // namespace musclewarp
