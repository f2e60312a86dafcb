// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/remeshing.h"

#include <glog/logging.h>

#include <set>
#include <utility>
#include <vector>

#include "musclewarp/cgal/even_remeshing.h"
#include "musclewarp/mesh/defects.h"
#include "musclewarp/proximity/mesh_intersection.h"

namespace musclewarp {
namespace {

// Marks the triangles of `surface` that are near those of `even` that cross.
void KeepAround(const TriangleSoup& even,
                const std::vector<std::pair<int, int>>& crossings,
                double distance,
                const TriangleSoup& surface,
                std::vector<bool>* is_kept) {
  std::set<int> crossing;
  for (const auto& [f, g] : crossings) crossing.insert({f, g});
  const Triangles triangles = even.triangles(
      std::vector<int>(crossing.begin(), crossing.end()), Eigen::all);
  const TriangleBvh tree(even.points, triangles);
  for (Eigen::Index f = 0; f < surface.triangles.rows(); ++f) {
    const Eigen::RowVector3d middle =
        CornersOf(surface.points, surface.triangles.row(f)).colwise().mean();
    if (tree.IsWithin(middle, distance)) (*is_kept)[f] = true;
  }
}

}  // namespace

TriangleSoup RemeshedWithoutCrossings(
    const TriangleSoup& surface,
    double edge_length,
    const std::function<void(TriangleSoup*)>& finish) {
  constexpr int kMaxAttempts = 5;
  std::vector<bool> is_kept(surface.triangles.rows(), false);
  for (int attempt = 1; attempt <= kMaxAttempts; ++attempt) {
    TriangleSoup even = Remeshed(surface, edge_length, is_kept);
    if (finish) finish(&even);
    const std::vector<std::pair<int, int>> crossings = SelfIntersections(even);
    VLOG(1) << surface.triangles.rows() << " triangles, "
            << even.triangles.rows() << " with edges of " << edge_length
            << " mm, " << crossings.size() << " pairs cross each other";
    if (crossings.empty()) return CountDefects(even).IsClean() ? even : surface;
    // In later attempts farther around, so that the border of what is kept
    // moves away from thin parts.
    KeepAround(even, crossings, attempt * edge_length, surface, &is_kept);
  }
  return surface;
}

}  // namespace musclewarp
