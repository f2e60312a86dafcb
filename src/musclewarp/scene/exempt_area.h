// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace musclewarp {

// The part of a muscle that may be inside a bone, because an attachment there
// has `may_penetrate`. What crosses or lies inside there is counted apart.
struct ExemptArea {
  // Indices of the two meshes among the muscles and the bones of the scene.
  int muscle = -1;
  int bone = -1;

  // True for each vertex of the muscle (#V) in the area, and for each of its
  // triangles (#F) that has such a vertex.
  std::vector<char> vertices;
  std::vector<char> triangles;
};

// Returns the area of a muscle for a bone, or null if there is none.
inline const ExemptArea* FindExempt(const std::vector<ExemptArea>& areas,
                                    int muscle,
                                    int bone) {
  for (const ExemptArea& area : areas) {
    if (area.muscle == muscle && area.bone == bone) return &area;
  }
  return nullptr;
}

}  // namespace musclewarp
