// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh/defects.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <vector>

#include "musclewarp/mesh/connectivity.h"
#include "musclewarp/mesh/measures.h"

namespace musclewarp {
namespace {

int CountDuplicatePoints(const Points& points) {
  std::vector<std::array<double, 3>> sorted(points.rows());
  for (int v = 0; v < points.rows(); ++v) {
    sorted[v] = {points(v, 0), points(v, 1), points(v, 2)};
  }
  std::sort(sorted.begin(), sorted.end());
  const auto end = std::unique(sorted.begin(), sorted.end());
  return static_cast<int>(sorted.end() - end);
}

int CountDuplicateTriangles(const Triangles& triangles) {
  std::vector<std::array<int, 3>> sorted;
  for (int f = 0; f < triangles.rows(); ++f) {
    if (HasRepeatedCorner(triangles, f)) continue;
    sorted.push_back({triangles(f, 0), triangles(f, 1), triangles(f, 2)});
    std::sort(sorted.back().begin(), sorted.back().end());
  }
  std::sort(sorted.begin(), sorted.end());
  const auto end = std::unique(sorted.begin(), sorted.end());
  return static_cast<int>(sorted.end() - end);
}

int CountUnreferencedPoints(const TriangleSoup& soup) {
  std::vector<bool> is_used(soup.points.rows(), false);
  for (int i = 0; i < soup.triangles.size(); ++i) {
    is_used[soup.triangles.data()[i]] = true;
  }
  return static_cast<int>(std::count(is_used.begin(), is_used.end(), false));
}

void CountEdges(const TriangleSoup& soup,
                const EdgeUses& edges,
                MeshDefects* defects) {
  for (const auto& uses : edges) {
    const int a = OriginOf(soup.triangles, uses[0]);
    const int b = TargetOf(soup.triangles, uses[0]);
    if (uses.size() == 1) {
      ++defects->border_edges;
      defects->border_length +=
          (soup.points.row(a) - soup.points.row(b)).norm();
    } else if (uses.size() > 2) {
      ++defects->non_manifold_edges;
    } else if (OriginOf(soup.triangles, uses[1]) == a) {
      ++defects->misoriented_edges;
    }
  }
}

// Counts the vertices whose corners form several fans.
int CountNonManifoldVertices(const TriangleSoup& soup, const EdgeUses& edges) {
  const Triangles& triangles = soup.triangles;
  DisjointSets fans(static_cast<int>(triangles.size()));
  for (const auto& uses : edges) {
    for (const int h : uses) {
      const bool same = OriginOf(triangles, h) == OriginOf(triangles, uses[0]);
      const int next = NextHalfEdge(uses[0]);
      fans.Join(h, same ? uses[0] : next);
      fans.Join(NextHalfEdge(h), same ? next : uses[0]);
    }
  }
  std::vector<int> num_fans(soup.points.rows(), 0);
  for (int h = 0; h < triangles.size(); ++h) {
    if (HasRepeatedCorner(triangles, h / 3)) continue;
    if (fans.Find(h) == h) ++num_fans[OriginOf(triangles, h)];
  }
  return static_cast<int>(std::count_if(
      num_fans.begin(), num_fans.end(), [](int n) { return n > 1; }));
}

}  // namespace

bool IsDegenerate(const TriangleSoup& soup, int f) {
  const Eigen::RowVector3d a = soup.points.row(soup.triangles(f, 0));
  const Eigen::RowVector3d b = soup.points.row(soup.triangles(f, 1));
  const Eigen::RowVector3d c = soup.points.row(soup.triangles(f, 2));
  // Rounding may hide a zero from one corner and show it from another: asking
  // all three makes the answer independent of the order of the corners.
  return (b - a).cross(c - a).isZero(0) || (c - b).cross(a - b).isZero(0) ||
         (a - c).cross(b - c).isZero(0);
}

bool MeshDefects::IsClean() const {
  return components == 1 && IsCleanInPieces();
}

bool MeshDefects::IsCleanInPieces() const {
  return is_closed_manifold && components > 0 && !is_inside_out &&
         duplicate_points == 0 && unreferenced_points == 0 &&
         degenerate_triangles == 0 && duplicate_triangles == 0 &&
         misoriented_edges == 0;
}

MeshDefects CountDefects(const TriangleSoup& soup) {
  MeshDefects defects;
  defects.duplicate_points = CountDuplicatePoints(soup.points);
  defects.unreferenced_points = CountUnreferencedPoints(soup);
  bool has_repeated_corner = false;
  for (int f = 0; f < soup.triangles.rows(); ++f) {
    if (IsDegenerate(soup, f)) ++defects.degenerate_triangles;
    if (HasRepeatedCorner(soup.triangles, f)) has_repeated_corner = true;
  }
  defects.duplicate_triangles = CountDuplicateTriangles(soup.triangles);
  const EdgeUses edges(soup.triangles);
  CountEdges(soup, edges, &defects);
  defects.non_manifold_vertices = CountNonManifoldVertices(soup, edges);
  defects.components =
      ConnectedComponents(soup.triangles, edges, soup.triangles.size()).count;
  defects.is_closed_manifold =
      soup.triangles.rows() > 0 && !has_repeated_corner &&
      defects.border_edges == 0 && defects.non_manifold_edges == 0 &&
      defects.non_manifold_vertices == 0;
  defects.is_inside_out = defects.is_closed_manifold &&
                          defects.misoriented_edges == 0 &&
                          SignedVolume(soup.points, soup.triangles) < 0;
  return defects;
}

}  // namespace musclewarp
