// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/figures/intersections.h"

namespace musclewarp {

std::optional<double> SceneIntersections::SmallestGap() const {
  std::optional<double> smallest;
  for (const MeshGap& gap : gaps) {
    if (!smallest || gap.at_least_mm < *smallest) smallest = gap.at_least_mm;
  }
  return smallest;
}

void SceneIntersections::DropLists() {
  inside_of_muscles.clear();
  self_pairs_of_muscles.clear();
  for (PairFigures& pair : pairs) {
    pair.triangles_of_a.clear();
    pair.triangles_of_b.clear();
  }
}

}  // namespace musclewarp
