// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/initial_separation/cell_surface.h"

#include <glog/logging.h>

#include <algorithm>
#include <set>
#include <utility>

#include "musclewarp/base/infinity.h"
#include "musclewarp/base/option_check.h"
#include "musclewarp/geometry/remeshing.h"
#include "musclewarp/initial_separation/marching_tetrahedra.h"
#include "musclewarp/mesh/connectivity.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/proximity/mesh_intersection.h"

namespace musclewarp {
namespace {

// Returns the triangles of a mesh that cross other triangles of the mesh.
TriangleBvh CrossingTriangles(const SearchableMesh& mesh) {
  std::set<int> crossing;
  for (const auto& [f, g] : SelfIntersections(mesh.bvh())) {
    crossing.insert({f, g});
  }
  return TriangleBvh(
      mesh.points(),
      mesh.triangles()(std::vector<int>(crossing.begin(), crossing.end()),
                       Eigen::all));
}

}  // namespace

bool CellSurfaceOptions::IsValid(std::string* error) const {
  return OptionCheck("CellSurfaceOptions", error)
             .IsAbove("spacing", spacing, 0)
             .IsAtLeast("bridge", bridge, 0)
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
  const TriangleBvh crossing = options.bridge > 0
                                   ? CrossingTriangles(muscle.mesh())
                                   : TriangleBvh(Points(), Triangles());
  const double bridge = options.bridge * options.spacing;
  Box3 box = muscle.mesh().bvh().box();
  for (int k = 0; k < 3; ++k) {
    box.lower[k] -= bridge;
    box.upper[k] += bridge;
  }
  TriangleSoup surface = MarchingTetrahedra(
      [&](const Eigen::RowVector3d& p) {
        double own = muscle.At(p, kInfinity);
        if (crossing.num_triangles() > 0) {
          own = std::min(own,
                         crossing.ClosestPoint(p, kInfinity).distance - bridge);
        }
        return cell.RegionDistance(p, own);
      },
      box,
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
  // New triangles must be larger than those that are kept.
  const double shortest = 2 * TypicalEdge(surface.points, surface.triangles);
  for (;; edge_length /= 2) {
    TriangleSoup even = RemeshedWithoutCrossings(surface, edge_length);
    const double volume = SignedVolume(even.points, even.triangles);
    if (volume >= least || edge_length / 2 < shortest) return even;
  }
}

}  // namespace musclewarp
