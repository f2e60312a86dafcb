// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// How two meshes intersect. "Inside" is a generalized winding number above 1/2,
// which has an answer for open and non-manifold meshes too.
struct MeshIntersection {
  // Triangles of a and of b that share a point, by an exact test.
  std::vector<std::pair<int, int>> triangle_pairs;
  std::vector<int> a_inside_b;  // vertices
  std::vector<int> b_inside_a;
  double max_depth_mm = 0;  // deepest inside vertex to the other's surface
};

}  // namespace musclewarp
