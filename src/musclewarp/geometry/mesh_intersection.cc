// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/mesh_intersection.h"

#include <glog/logging.h>

#include <algorithm>
#include <numeric>

#include "musclewarp/geometry/triangle_intersection.h"

namespace musclewarp {
namespace {

using PairList = std::vector<std::pair<int, int>>;

std::vector<bool> UsedPoints(const SearchableMesh& mesh) {
  std::vector<bool> is_used(mesh.points().rows(), false);
  for (Eigen::Index i = 0; i < mesh.triangles().size(); ++i) {
    is_used[mesh.triangles().data()[i]] = true;
  }
  return is_used;
}

// #V: a vertex that is reached over triangles which are not `crossing`.
std::vector<int> Representatives(const SearchableMesh& mesh,
                                 const std::vector<bool>& crossing) {
  std::vector<int> parent(mesh.points().rows());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (int f = 0; f < mesh.triangles().rows(); ++f) {
    if (crossing[f]) continue;
    for (int corner = 1; corner < 3; ++corner) {
      const int a = root(mesh.triangles()(f, 0));
      const int b = root(mesh.triangles()(f, corner));
      parent[std::max(a, b)] = std::min(a, b);
    }
  }
  for (int v = 0; v < static_cast<int>(parent.size()); ++v) parent[v] = root(v);
  return parent;
}

// The used vertices of `mesh` inside `other`. Over triangles that do not cross
// a closed surface nothing changes, so there one vertex speaks for all it
// reaches.
std::vector<int> VerticesInside(const SearchableMesh& mesh,
                                const SearchableMesh& other,
                                const std::vector<bool>& crossing) {
  const int count = static_cast<int>(mesh.points().rows());
  if (other.bvh().num_triangles() == 0) return {};
  const std::vector<bool> is_used = UsedPoints(mesh);
  std::vector<int> representative(count);
  if (other.winding().IsClosed()) {
    representative = Representatives(mesh, crossing);
  } else {
    std::iota(representative.begin(), representative.end(), 0);
  }
  std::vector<char> is_inside(count, 0);
#pragma omp parallel for schedule(dynamic, 64)
  for (int v = 0; v < count; ++v) {
    if (representative[v] != v || !is_used[v]) continue;
    const Eigen::RowVector3d p = mesh.points().row(v);
    is_inside[v] = other.bvh().box().Contains(p) && other.winding().IsInside(p);
  }
  std::vector<int> inside;
  for (int v = 0; v < count; ++v) {
    if (is_used[v] && is_inside[representative[v]]) inside.push_back(v);
  }
  return inside;
}

double Depth(const Points& points,
             const std::vector<int>& inside,
             const TriangleBvh& surface) {
  double depth = 0;
#pragma omp parallel for schedule(dynamic, 64) reduction(max : depth)
  for (size_t i = 0; i < inside.size(); ++i) {
    depth =
        std::max(depth, surface.ClosestPoint(points.row(inside[i])).distance);
  }
  return depth;
}

}  // namespace

SearchableMesh::SearchableMesh(TriangleSoup soup)
    : soup_(std::move(soup)),
      bvh_(soup_.points, soup_.triangles),
      winding_(&bvh_, soup_.triangles) {}

void SearchableMesh::Refit(const Points& points) {
  CHECK_EQ(points.rows(), soup_.points.rows());
  soup_.points = points;
  bvh_.Refit(points);
}

MeshIntersection IntersectMeshes(const SearchableMesh& a,
                                 const SearchableMesh& b) {
  MeshIntersection result;
  result.triangle_pairs = IntersectingTriangles(a.bvh(), b.bvh());
  std::vector<bool> crossing_a(a.triangles().rows(), false);
  std::vector<bool> crossing_b(b.triangles().rows(), false);
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
  PairList pairs = bvh.CollectSelfOverlaps([&](int f, int g) {
    return TrianglesIntersectBeyondCommon(bvh.corners(f), bvh.corners(g));
  });
  for (auto& [f, g] : pairs) {
    if (f > g) std::swap(f, g);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

PairList SelfIntersections(const TriangleSoup& soup) {
  return SelfIntersections(TriangleBvh(soup.points, soup.triangles));
}

}  // namespace musclewarp
