// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/initial_separation/cell_surface.h"

#include <glog/logging.h>

#include <algorithm>
#include <set>
#include <utility>

#include "musclewarp/base/option_check.h"
#include "musclewarp/geometry/remeshing.h"
#include "musclewarp/initial_separation/marching_tetrahedra.h"
#include "musclewarp/mesh/connectivity.h"
#include "musclewarp/mesh/defects.h"
#include "musclewarp/mesh/measures.h"
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

// Returns the surface with triangles of one size but around places where it
// would cross itself with them.
TriangleSoup EvenWithoutCrossings(const TriangleSoup& surface,
                                  double edge_length) {
  constexpr int kMaxAttempts = 5;
  std::vector<bool> is_kept(surface.triangles.rows(), false);
  for (int attempt = 1; attempt <= kMaxAttempts; ++attempt) {
    const TriangleSoup even = Remeshed(surface, edge_length, is_kept);
    const std::vector<std::pair<int, int>> crossings = SelfIntersections(even);
    VLOG(1) << "surface of a cell: " << surface.triangles.rows()
            << " triangles, " << even.triangles.rows() << " with edges of "
            << edge_length << " mm, " << crossings.size()
            << " pairs cross each other";
    if (crossings.empty()) return CountDefects(even).IsClean() ? even : surface;
    // In later attempts farther around, so that the border of what is kept
    // moves away from thin parts.
    KeepAround(even, crossings, attempt * edge_length, surface, &is_kept);
  }
  return surface;
}

}  // namespace

bool CellSurfaceOptions::IsValid(std::string* error) const {
  return OptionCheck("CellSurfaceOptions", error)
             .IsAbove("spacing", spacing, 0)
             .is_valid() &&
         cell.IsValid(error);
}

void KeepLargestBody(TriangleSoup* soup) {
  const Components components = ConnectedComponents(
      soup->triangles, EdgeUses(soup->triangles), soup->triangles.size());
  std::vector<double> volumes(components.count, 0);
  for (Eigen::Index f = 0; f < soup->triangles.rows(); ++f) {
    volumes[components.label[f]] +=
        SignedVolume(soup->points, soup->triangles.row(f));
  }
  const auto largest =
      std::max_element(volumes.begin(), volumes.end()) - volumes.begin();
  std::vector<bool> keep(soup->triangles.rows());
  for (size_t f = 0; f < keep.size(); ++f) {
    keep[f] = components.label[f] == largest;
  }
  KeepTriangles(keep, &soup->triangles);
  DropUnreferencedPoints(soup);
}

TriangleSoup CellSurface(const CellSurfaceOptions& options,
                         const SolidDistance& muscle,
                         const std::vector<const SolidDistance*>& other_muscles,
                         const std::vector<const SolidDistance*>& bones) {
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  const MedialCell cell(options.cell, muscle, other_muscles, bones);
  TriangleSoup surface = MarchingTetrahedra(
      [&](const Eigen::RowVector3d& p) { return cell.RegionDistance(p); },
      muscle.mesh().bvh().box(),
      options.spacing);
  if (surface.triangles.rows() > 0) KeepLargestBody(&surface);
  return surface;
}

TriangleSoup WithEvenTriangles(const TriangleSoup& surface,
                               double edge_length) {
  CHECK_GT(edge_length, 0);
  if (surface.triangles.rows() == 0) return surface;
  constexpr double kMaxLoss = 0.05;  // of the volume
  const double least =
      (1 - kMaxLoss) * SignedVolume(surface.points, surface.triangles);
  // Triangles that are kept have to be the smaller ones.
  const double shortest = 2 * TypicalEdge(surface.points, surface.triangles);
  for (;; edge_length /= 2) {
    TriangleSoup even = EvenWithoutCrossings(surface, edge_length);
    const double volume = SignedVolume(even.points, even.triangles);
    if (volume >= least || edge_length / 2 < shortest) return even;
  }
}

}  // namespace musclewarp
