// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certificate/scene_intersections.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "musclewarp/base/parallel_for.h"
#include "musclewarp/certificate/containment.h"
#include "musclewarp/certificate/crossing_triangles.h"
#include "musclewarp/certificate/mesh_distance.h"

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

// Returns true if a component of `mesh`, which does not cross `other`, lies in
// it.
bool LiesInside(const SearchableMesh& mesh,
                const SearchableMesh& other,
                const BoxedMesh& boxed_other) {
  if (other.triangles().rows() == 0) return false;
  const int count = static_cast<int>(mesh.points().rows());
  bool is_inside = false;
  for (int v = 0; v < count && !is_inside; ++v) {
    if (!mesh.is_used()[v] || mesh.components()[v] != v) continue;
    const Eigen::RowVector3d p = mesh.points().row(v);
    is_inside = other.winding().IsClosed() ? IsInsideClosed(p, boxed_other)
                                           : other.winding().IsInside(p);
  }
  return is_inside;
}

// Two meshes and their triangles that cross.
struct MeshPair {
  const NamedMesh& a;
  const NamedMesh& b;
  int muscle_a, muscle_b;  // their numbers, -1 for a bone
  std::vector<int> triangles_of_a, triangles_of_b;
  const ExemptArea* exempt = nullptr;
  int exempt_pairs = 0;
};

// Returns the pair of muscle `a` and mesh `b`, where bones come after muscles.
MeshPair PairOf(const std::vector<NamedMesh>& muscles,
                const std::vector<NamedMesh>& bones,
                const std::vector<ExemptArea>& exempt,
                size_t a,
                size_t b) {
  const int muscle = static_cast<int>(a);
  if (b < muscles.size()) {
    return {muscles[a], muscles[b], muscle, static_cast<int>(b), {}, {}};
  }
  const size_t bone = b - muscles.size();
  MeshPair pair = {muscles[a], bones[bone], muscle, -1, {}, {}};
  pair.exempt = FindExempt(exempt, muscle, static_cast<int>(bone));
  return pair;
}

void DropExempt(const ExemptArea& exempt, std::vector<int>* vertices) {
  vertices->erase(std::remove_if(vertices->begin(),
                                 vertices->end(),
                                 [&](int v) { return exempt.vertices[v]; }),
                  vertices->end());
}

// Says more of two meshes that cross or contain each other. The vertices inside
// are added to those of the muscles; null for a bone. Returns true if the
// meshes have more in common than exempt triangles.
bool AddPair(MeshPair meshes,
             const BoxedMesh& boxed_a,
             const BoxedMesh& boxed_b,
             std::vector<int>* inside_of_a,
             std::vector<int>* inside_of_b,
             SceneIntersections* sum) {
  const SearchableMesh &a = *meshes.a.mesh, &b = *meshes.b.mesh;
  PairFigures pair;
  pair.triangle_pairs = static_cast<int>(meshes.triangles_of_a.size());
  pair.exempt_pairs = meshes.exempt_pairs;
  if (pair.triangle_pairs + pair.exempt_pairs == 0 &&
      !LiesInside(a, b, boxed_b) && !LiesInside(b, a, boxed_a)) {
    return false;
  }
  MeshIntersection found = IntersectMeshes(a, b);
  if (pair.exempt_pairs > 0 && pair.triangle_pairs == 0) {
    DropExempt(*meshes.exempt, &found.a_inside_b);
    found.b_inside_a.clear();
    if (found.a_inside_b.empty()) found.max_depth_mm = 0;
  }
  AddTo(found.a_inside_b, inside_of_a);
  if (inside_of_b) AddTo(found.b_inside_a, inside_of_b);
  pair.a = meshes.a.name;
  pair.b = meshes.b.name;
  pair.muscle_a = meshes.muscle_a;
  pair.muscle_b = meshes.muscle_b;
  pair.vertices_inside =
      static_cast<int>(found.a_inside_b.size() + found.b_inside_a.size());
  pair.max_depth_mm = found.max_depth_mm;
  pair.triangles_of_a = Distinct(std::move(meshes.triangles_of_a));
  pair.triangles_of_b = Distinct(std::move(meshes.triangles_of_b));
  for (const int f : pair.triangles_of_a) {
    for (const int v : a.triangles().row(f)) pair.place += a.points().row(v);
  }
  if (!pair.triangles_of_a.empty()) {
    pair.place /= 3 * static_cast<double>(pair.triangles_of_a.size());
  } else if (!found.a_inside_b.empty()) {
    pair.place = a.points().row(found.a_inside_b[0]);
  } else if (!found.b_inside_a.empty()) {
    pair.place = b.points().row(found.b_inside_a[0]);
  }
  sum->triangle_pairs += pair.triangle_pairs;
  sum->exempt_pairs += pair.exempt_pairs;
  sum->vertices_inside += pair.vertices_inside;
  sum->max_depth_mm = std::max(sum->max_depth_mm, pair.max_depth_mm);
  sum->pairs.push_back(pair);
  return pair.Counts();
}

// Adds the gap between two meshes that do not intersect.
void AddGap(const DistanceSearch& search,
            const BoxedMesh& other,
            const MeshPair& meshes,
            SceneIntersections* sum) {
  const auto distance =
      search.To(other, meshes.exempt ? &meshes.exempt->triangles : nullptr);
  if (!distance) return;
  sum->gaps.push_back({meshes.a.name,
                       meshes.b.name,
                       distance->at_least,
                       distance->at_most,
                       distance->place,
                       meshes.muscle_a,
                       meshes.muscle_b});
}

}  // namespace

SceneIntersections IntersectScene(const std::vector<NamedMesh>& muscles,
                                  const std::vector<NamedMesh>& bones,
                                  const std::vector<ExemptArea>& exempt) {
  std::vector<BoxedMesh> boxed;
  for (const NamedMesh& muscle : muscles) boxed.emplace_back(muscle.view());
  for (const NamedMesh& bone : bones) boxed.emplace_back(bone.view());
  const auto pairs = CrossingTriangles(boxed, muscles.size());
  // They ascend by a, then b, as the loops below do.
  auto next = pairs.begin();
  const auto crossing = [&](size_t a, size_t b) {
    MeshPair meshes = PairOf(muscles, bones, exempt, a, b);
    for (; next != pairs.end() && next->a == static_cast<int>(a) &&
           next->b == static_cast<int>(b);
         ++next) {
      if (meshes.exempt && meshes.exempt->triangles[next->f]) {
        ++meshes.exempt_pairs;
        continue;
      }
      meshes.triangles_of_a.push_back(next->f);
      meshes.triangles_of_b.push_back(next->g);
    }
    return meshes;
  };
  std::vector<std::optional<DistanceSearch>> searches(muscles.size());
  ParallelFor(muscles.size(),
              [&](size_t a) { searches[a].emplace(boxed[a], kMeshGapLimit); });
  SceneIntersections sum;
  std::vector<std::vector<int>> inside(muscles.size());
  for (size_t a = 0; a < muscles.size(); ++a) {
    sum.self_pairs_of_muscles.push_back(
        static_cast<int>(crossing(a, a).triangles_of_a.size()));
    sum.self_pairs += sum.self_pairs_of_muscles.back();
    for (size_t b = a + 1; b < muscles.size() + bones.size(); ++b) {
      const MeshPair meshes = crossing(a, b);
      std::vector<int>* inside_of_b = b < muscles.size() ? &inside[b] : nullptr;
      if (AddPair(meshes, boxed[a], boxed[b], &inside[a], inside_of_b, &sum)) {
        sum.gaps.push_back({meshes.a.name,
                            meshes.b.name,
                            /*at_least_mm=*/0,
                            /*at_most_mm=*/0,
                            sum.pairs.back().place,
                            meshes.muscle_a,
                            meshes.muscle_b});
      } else {
        AddGap(*searches[a], boxed[b], meshes, &sum);
      }
    }
  }
  sum.inside_of_muscles = std::move(inside);
  return sum;
}

std::vector<PairDepth> PenetrationDepths(const std::vector<NamedMesh>& muscles,
                                         const std::vector<NamedMesh>& bones) {
  std::vector<PairDepth> pairs;
  for (int a = 0; a < static_cast<int>(muscles.size()); ++a) {
    for (int b = a + 1; b < static_cast<int>(muscles.size()); ++b) {
      pairs.push_back({a, b, false, 0});
    }
    for (int b = 0; b < static_cast<int>(bones.size()); ++b) {
      pairs.push_back({a, b, true, 0});
    }
  }
#pragma omp parallel for schedule(dynamic, 1)
  for (size_t i = 0; i < pairs.size(); ++i) {
    PairDepth& pair = pairs[i];
    const NamedMesh& other = pair.is_bone ? bones[pair.b] : muscles[pair.b];
    pair.depth =
        IntersectMeshes(*muscles[pair.a].mesh, *other.mesh).max_depth_mm;
  }
  pairs.erase(
      std::remove_if(pairs.begin(),
                     pairs.end(),
                     [](const PairDepth& pair) { return pair.depth == 0; }),
      pairs.end());
  return pairs;
}

namespace {

// The trees of all meshes but that of a muscle.
std::vector<const TriangleBvh*> TreesBeside(
    size_t muscle,
    const std::vector<NamedMesh>& muscles,
    const std::vector<NamedMesh>& bones) {
  std::vector<const TriangleBvh*> others;
  for (size_t i = 0; i < muscles.size(); ++i) {
    if (i != muscle) others.push_back(&muscles[i].mesh->bvh());
  }
  for (const NamedMesh& bone : bones) others.push_back(&bone.mesh->bvh());
  return others;
}

// Returns the distance of a point to the nearest of several meshes, or `limit`
// if none is nearer.
double DistanceTo(const std::vector<const TriangleBvh*>& meshes,
                  const Eigen::RowVector3d& point,
                  double limit) {
  for (const TriangleBvh* mesh : meshes) {
    limit = std::min(limit, mesh->ClosestPoint(point, limit).distance);
  }
  return limit;
}

}  // namespace

Eigen::VectorXd VertexGaps(size_t muscle,
                           const std::vector<NamedMesh>& muscles,
                           const std::vector<NamedMesh>& bones,
                           const std::vector<int>& inside,
                           double limit) {
  const std::vector<const TriangleBvh*> others =
      TreesBeside(muscle, muscles, bones);
  const Points& points = muscles[muscle].mesh->points();
  Eigen::VectorXd gaps(points.rows());
#pragma omp parallel for schedule(dynamic, 64)
  for (Eigen::Index v = 0; v < points.rows(); ++v) {
    gaps[v] = DistanceTo(others, points.row(v), limit);
  }
  for (const int v : inside) gaps[v] = -gaps[v];
  return gaps;
}

double SmallestVertexGap(size_t muscle,
                         const std::vector<NamedMesh>& muscles,
                         const std::vector<NamedMesh>& bones,
                         const std::vector<int>& inside,
                         double limit) {
  const std::vector<const TriangleBvh*> others =
      TreesBeside(muscle, muscles, bones);
  const Points& points = muscles[muscle].mesh->points();
  double deepest = 0;
  for (const int v : inside) {
    deepest = std::max(deepest, DistanceTo(others, points.row(v), limit));
  }
  if (!inside.empty()) return -deepest;
  double smallest = limit;
  // Few vertices, spread over the mesh, shorten the search for the others.
  constexpr Eigen::Index kSampleStride = 64;
  for (const Eigen::Index stride : {kSampleStride, Eigen::Index{1}}) {
    double found = smallest;
#pragma omp parallel for schedule(static) firstprivate(smallest) \
    reduction(min                                                \
              : found)
    for (Eigen::Index v = 0; v < points.rows(); v += stride) {
      smallest = DistanceTo(others, points.row(v), smallest);
      found = std::min(found, smallest);
    }
    smallest = found;
  }
  return smallest;
}

}  // namespace musclewarp
