// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/contact/scene_intersections.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace musclewarp {
namespace {

void AddTo(const std::vector<int>& vertices, std::vector<int>* sum) {
  std::vector<int> both;
  std::set_union(sum->begin(),
                 sum->end(),
                 vertices.begin(),
                 vertices.end(),
                 std::back_inserter(both));
  *sum = std::move(both);
}

std::vector<int> Distinct(std::vector<int> numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

// The vertices inside are added to those of the muscles; null for a bone.
void AddPair(const NamedMesh& a,
             const NamedMesh& b,
             std::vector<int>* inside_of_a,
             std::vector<int>* inside_of_b,
             SceneIntersections* sum) {
  const MeshIntersection found = IntersectMeshes(*a.mesh, *b.mesh);
  if (found.IsEmpty()) return;
  AddTo(found.a_inside_b, inside_of_a);
  if (inside_of_b) AddTo(found.b_inside_a, inside_of_b);
  PairIntersection pair;
  pair.a = a.name;
  pair.b = b.name;
  pair.triangle_pairs = static_cast<int>(found.triangle_pairs.size());
  pair.vertices_inside =
      static_cast<int>(found.a_inside_b.size() + found.b_inside_a.size());
  pair.max_depth_mm = found.max_depth_mm;
  for (const auto& [f, g] : found.triangle_pairs) {
    pair.triangles_of_a.push_back(f);
    pair.triangles_of_b.push_back(g);
  }
  pair.triangles_of_a = Distinct(std::move(pair.triangles_of_a));
  pair.triangles_of_b = Distinct(std::move(pair.triangles_of_b));
  sum->triangle_pairs += pair.triangle_pairs;
  sum->vertices_inside += pair.vertices_inside;
  sum->max_depth_mm = std::max(sum->max_depth_mm, pair.max_depth_mm);
  sum->pairs.push_back(pair);
}

}  // namespace

void SceneIntersections::DropLists() {
  inside_of_muscles.clear();
  self_pairs_of_muscles.clear();
  for (PairIntersection& pair : pairs) {
    pair.triangles_of_a.clear();
    pair.triangles_of_b.clear();
  }
}

SceneIntersections IntersectScene(const std::vector<NamedMesh>& muscles,
                                  const std::vector<NamedMesh>& bones) {
  SceneIntersections sum;
  std::vector<std::vector<int>> inside(muscles.size());
  for (size_t a = 0; a < muscles.size(); ++a) {
    for (size_t b = a + 1; b < muscles.size(); ++b) {
      AddPair(muscles[a], muscles[b], &inside[a], &inside[b], &sum);
    }
    for (const NamedMesh& bone : bones) {
      AddPair(muscles[a], bone, &inside[a], nullptr, &sum);
    }
    sum.self_pairs_of_muscles.push_back(
        static_cast<int>(SelfIntersections(muscles[a].mesh->bvh()).size()));
    sum.self_pairs += sum.self_pairs_of_muscles.back();
  }
  sum.inside_of_muscles = std::move(inside);
  return sum;
}

std::vector<double> PenetrationDepths(const std::vector<NamedMesh>& muscles,
                                      const std::vector<NamedMesh>& bones) {
  std::vector<double> depths(muscles.size(), 0);
  for (size_t a = 0; a < muscles.size(); ++a) {
    for (size_t b = a + 1; b < muscles.size(); ++b) {
      const double depth =
          IntersectMeshes(*muscles[a].mesh, *muscles[b].mesh).max_depth_mm;
      depths[a] = std::max(depths[a], depth);
      depths[b] = std::max(depths[b], depth);
    }
    for (const NamedMesh& bone : bones) {
      depths[a] =
          std::max(depths[a],
                   IntersectMeshes(*muscles[a].mesh, *bone.mesh).max_depth_mm);
    }
  }
  return depths;
}

Eigen::VectorXd VertexGaps(size_t muscle,
                           const std::vector<NamedMesh>& muscles,
                           const std::vector<NamedMesh>& bones,
                           const std::vector<int>& inside,
                           double limit) {
  std::vector<const TriangleBvh*> others;
  for (size_t i = 0; i < muscles.size(); ++i) {
    if (i != muscle) others.push_back(&muscles[i].mesh->bvh());
  }
  for (const NamedMesh& bone : bones) others.push_back(&bone.mesh->bvh());
  const Points& points = muscles[muscle].mesh->points();
  Eigen::VectorXd gaps(points.rows());
#pragma omp parallel for schedule(dynamic, 64)
  for (Eigen::Index v = 0; v < points.rows(); ++v) {
    double gap = limit;
    for (const TriangleBvh* other : others) {
      gap = std::min(gap, other->ClosestPoint(points.row(v), gap).distance);
    }
    gaps[v] = gap;
  }
  for (const int v : inside) gaps[v] = -gaps[v];
  return gaps;
}

}  // namespace musclewarp
