// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/cell_surface.h"

#include <glog/logging.h>

#include <algorithm>

#include "musclewarp/base/option_check.h"
#include "musclewarp/geometry/marching_tetrahedra.h"
#include "musclewarp/geometry/remeshing.h"
#include "musclewarp/mesh/connectivity.h"
#include "musclewarp/mesh/defects.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/mesh_repair/self_crossing_removal.h"

namespace musclewarp {
namespace {

// Deletes all components but the one that encloses the largest volume.
void KeepLargestBody(TriangleSoup* soup) {
  const Components components = ConnectedComponents(
      soup->triangles, UsesOfEdges(soup->triangles), soup->triangles.size());
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

}  // namespace

bool CellSurfaceOptions::IsValid(std::string* error) const {
  return OptionCheck("CellSurfaceOptions", error)
             .IsAbove("spacing", spacing, 0)
             .is_valid() &&
         cell.IsValid(error);
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
                               double shortest,
                               double longest) {
  CHECK_GT(shortest, 0);
  constexpr double kShorter = 0.7;
  for (double length = longest;;
       length = std::max(kShorter * length, shortest)) {
    TriangleSoup even = Remeshed(surface, length);
    const SelfCrossingRemoval removal = RemoveSelfCrossings(&even);
    VLOG(1) << "surface of a cell: " << surface.triangles.rows()
            << " triangles, " << even.triangles.rows() << " with edges of "
            << length << " mm, self-crossings " << removal.pairs_before
            << " before and " << removal.pairs_after << " after their removal";
    if (removal.pairs_after == 0 && CountDefects(even).IsClean()) return even;
    if (length <= shortest) return surface;
  }
}

}  // namespace musclewarp
