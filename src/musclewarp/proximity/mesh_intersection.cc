// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/proximity/mesh_intersection.h"

#include <glog/logging.h>

#include <algorithm>
#include <numeric>

#include "musclewarp/cgal/triangle_intersection.h"
#include "musclewarp/mesh/connectivity.h"
#include "musclewarp/proximity/self_crossing_search.h"

namespace musclewarp {
namespace {

using PairList = std::vector<std::pair<int, int>>;

std::vector<char> UsedPoints(const TriangleSoup& soup) {
  std::vector<char> is_used(soup.points.rows(), false);
  for (Eigen::Index i = 0; i < soup.triangles.size(); ++i) {
    is_used[soup.triangles.data()[i]] = true;
  }
  return is_used;
}

// #V: a vertex that is reached over triangles which are `passable` (#F).
template <typename IsPassable>
std::vector<int> Representatives(const Triangles& triangles,
                                 Eigen::Index vertices,
                                 const IsPassable& is_passable) {
  DisjointSets sets(static_cast<int>(vertices));
  for (int f = 0; f < triangles.rows(); ++f) {
    if (!is_passable(f)) continue;
    for (const int corner : {1, 2}) {
      sets.Join(triangles(f, 0), triangles(f, corner));
    }
  }
  std::vector<int> representatives(vertices);
  for (int v = 0; v < static_cast<int>(vertices); ++v) {
    representatives[v] = sets.Find(v);
  }
  return representatives;
}

// The used vertices of `mesh` inside `other`, which cross in the triangles
// `crossing` (#F of mesh; empty: nowhere). Over triangles that do not cross a
// closed surface nothing changes, so there one vertex speaks for all it
// reaches.
std::vector<int> VerticesInside(const SearchableMesh& mesh,
                                const SearchableMesh& other,
                                const std::vector<bool>& crossing) {
  const int count = static_cast<int>(mesh.points().rows());
  if (other.bvh().num_triangles() == 0) return {};
  const Box3& box = other.bvh().box();
  std::vector<char> is_near(count);
  for (int v = 0; v < count; ++v) {
    is_near[v] = mesh.is_used()[v] && box.Contains(mesh.points().row(v));
  }
  std::vector<int> representative;
  if (!other.winding().IsClosed()) {
    representative.resize(count);
    std::iota(representative.begin(), representative.end(), 0);
  } else if (crossing.empty()) {
    representative = mesh.components();
  } else {
    representative = Representatives(mesh.triangles(), count, [&](int f) {
      const auto t = mesh.triangles().row(f);
      return !crossing[f] && is_near[t[0]] && is_near[t[1]] && is_near[t[2]];
    });
  }
  std::vector<char> is_inside(count, 0);
#pragma omp parallel for schedule(dynamic, 64)
  for (int v = 0; v < count; ++v) {
    if (representative[v] != v || !is_near[v]) continue;
    is_inside[v] = other.winding().IsInside(mesh.points().row(v));
  }
  std::vector<int> inside;
  for (int v = 0; v < count; ++v) {
    if (is_near[v] && is_inside[representative[v]]) inside.push_back(v);
  }
  return inside;
}

double Depth(const Points& points,
             const std::vector<int>& inside,
             const TriangleBvh& surface) {
  double depth = 0;
#pragma omp parallel for schedule(dynamic, 64) reduction(max : depth)
  for (size_t i = 0; i < inside.size(); ++i) {
    // Few are deeper than all before.
    const Eigen::RowVector3d p = points.row(inside[i]);
    if (surface.IsWithin(p, depth)) continue;
    depth = std::max(depth, surface.ClosestPoint(p).distance);
  }
  return depth;
}

// The pairs with the lower triangle first, in ascending order.
PairList Ascending(PairList pairs) {
  for (auto& [f, g] : pairs) {
    if (f > g) std::swap(f, g);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace

SearchableMesh::SearchableMesh(TriangleSoup soup)
    : soup_(std::move(soup)),
      bvh_(soup_.points, soup_.triangles),
      winding_(&bvh_, soup_.triangles),
      is_used_(UsedPoints(soup_)),
      components_(Representatives(
          soup_.triangles, soup_.points.rows(), [](int) { return true; })) {}

void SearchableMesh::Refit(const Points& points) {
  CHECK_EQ(points.rows(), soup_.points.rows());
  soup_.points = points;
  bvh_.Refit(points);
}

MeshIntersection IntersectMeshes(const SearchableMesh& a,
                                 const SearchableMesh& b) {
  MeshIntersection result;
  const bool are_empty =
      a.bvh().num_triangles() == 0 || b.bvh().num_triangles() == 0;
  if (are_empty || !a.bvh().box().Overlaps(b.bvh().box())) return result;
  result.triangle_pairs = IntersectingTriangles(a.bvh(), b.bvh());
  std::vector<bool> crossing_a, crossing_b;
  if (!result.triangle_pairs.empty()) {
    crossing_a.resize(a.triangles().rows(), false);
    crossing_b.resize(b.triangles().rows(), false);
  }
  for (const auto& [f, g] : result.triangle_pairs) {
    crossing_a[f] = true;
    crossing_b[g] = true;
  }
  result.a_inside_b = VerticesInside(a, b, crossing_a);
  result.b_inside_a = VerticesInside(b, a, crossing_b);
  result.a_depth_mm = Depth(a.points(), result.a_inside_b, b.bvh());
  result.b_depth_mm = Depth(b.points(), result.b_inside_a, a.bvh());
  result.max_depth_mm = std::max(result.a_depth_mm, result.b_depth_mm);
  return result;
}

MeshIntersection IntersectMeshes(const TriangleSoup& a, const TriangleSoup& b) {
  return IntersectMeshes(SearchableMesh(a), SearchableMesh(b));
}

PairList IntersectingTriangles(const TriangleBvh& a, const TriangleBvh& b) {
  PairList pairs = a.CollectOverlaps(b, [&](int f, int g) {
    return TrianglesIntersect(a.corners(f), b.corners(g));
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

PairList SelfIntersections(const TriangleBvh& bvh) {
  return Ascending(bvh.CollectSelfOverlaps([&](int f, int g) {
    return TrianglesIntersectBeyondCommon(bvh.corners(f), bvh.corners(g));
  }));
}

PairList SelfIntersections(const TriangleSoup& soup) {
  return SelfCrossingSearch(soup.points, soup.triangles).Find(soup.points);
}

}  // namespace musclewarp
