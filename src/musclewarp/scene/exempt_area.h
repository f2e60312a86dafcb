// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace musclewarp {

// What of a muscle may be in a bone. Meshes by their numbers in the scene.
struct ExemptArea {
  int muscle = -1;
  int bone = -1;
  std::vector<char> vertices;   // #V
  std::vector<char> triangles;  // #F: those at such a vertex
};

// The area for a muscle and a bone; null if there is none.
inline const ExemptArea* FindExempt(const std::vector<ExemptArea>& areas,
                                    int muscle,
                                    int bone) {
  for (const ExemptArea& area : areas) {
    if (area.muscle == muscle && area.bone == bone) return &area;
  }
  return nullptr;
}

}  // namespace musclewarp
