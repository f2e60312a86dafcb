// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/contact/scene_intersections.h"

#include <algorithm>

namespace musclewarp {
namespace {

void AddPair(const NamedMesh& a, const NamedMesh& b, SceneIntersections* sum) {
  const MeshIntersection found = IntersectMeshes(*a.mesh, *b.mesh);
  if (found.IsEmpty()) return;
  PairIntersection pair;
  pair.a = a.name;
  pair.b = b.name;
  pair.triangle_pairs = static_cast<int>(found.triangle_pairs.size());
  pair.vertices_inside =
      static_cast<int>(found.a_inside_b.size() + found.b_inside_a.size());
  pair.max_depth_mm = found.max_depth_mm;
  sum->triangle_pairs += pair.triangle_pairs;
  sum->vertices_inside += pair.vertices_inside;
  sum->max_depth_mm = std::max(sum->max_depth_mm, pair.max_depth_mm);
  sum->pairs.push_back(pair);
}

}  // namespace

SceneIntersections IntersectScene(const std::vector<NamedMesh>& muscles,
                                  const std::vector<NamedMesh>& bones) {
  SceneIntersections sum;
  for (size_t a = 0; a < muscles.size(); ++a) {
    for (size_t b = a + 1; b < muscles.size(); ++b) {
      AddPair(muscles[a], muscles[b], &sum);
    }
    for (const NamedMesh& bone : bones) AddPair(muscles[a], bone, &sum);
    sum.self_pairs +=
        static_cast<int>(SelfIntersections(muscles[a].mesh->bvh()).size());
  }
  return sum;
}

}  // namespace musclewarp
