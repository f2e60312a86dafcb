// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace musclewarp {

// The part of a muscle's surface that may penetrate a bone, because an
// attachment to it has `may_penetrate`. Crossings and penetrations in this part
// are counted separately.
struct ExemptArea {
  // Indices into the muscles and the bones of the scene.
  int muscle = -1;
  int bone = -1;

  // For each vertex of the muscle (#V), whether it is in the area; for each
  // triangle (#F), whether one of its vertices is.
  std::vector<char> vertices;
  std::vector<char> triangles;
};

// Returns the exempt area of a muscle in a bone, or null if there is none.
inline const ExemptArea* FindExempt(const std::vector<ExemptArea>& areas,
                                    int muscle,
                                    int bone) {
  for (const ExemptArea& area : areas) {
    if (area.muscle == muscle && area.bone == bone) return &area;
  }
  return nullptr;
}

}  // namespace musclewarp
