// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Points spread evenly over a surface, to which spheres, cylinders and axes are
// fitted. A fit to the vertices of a mesh would follow its triangulation: on
// 1300 vertices of a femur the axis of the knee is 12 degrees off.
struct SurfacePoints {
  Points points;    // #P x 3, mm
  Points normals;   // #P x 3, outward, of unit length
  double area = 0;  // that each point stands for, mm^2

  int size() const { return static_cast<int>(points.rows()); }
};

// The sampling of a surface.
struct SurfaceSampling {
  // Distance of neighbouring points, mm. On vertices the knee of BodyParts3D
  // was 12 degrees off, on points it is 2.
  double spacing = 1.2;

  // Normals are averaged over this, mm: about two points, and a voxel of most
  // images.
  double normal_radius = 2.5;

  // Pieces of a smaller fraction of the area are left out: crumbs of a
  // segmentation.
  double stray_fraction = 0.01;
};

// Returns points spread over a surface by area, whatever its triangulation.
// Normals are averaged over the neighbourhood, as those of voxels and of coarse
// triangles are of little use by themselves.
//
// The surface may have holes, duplicate points and triangles that run the wrong
// way: its triangles are oriented first (OrientConsistently). A piece that lies
// within another one, as the inner wall of the cortical bone does, is left out.
// There are no points for a surface without area.
SurfacePoints SampleSurface(const TriangleSoup& surface,
                            const SurfaceSampling& sampling = {});

// Returns the points with the mean of the normals within `radius` (mm) of each,
// of those that face the same way.
SurfacePoints WithAveragedNormals(SurfacePoints surface, double radius);

// Returns some of the points, in the order of `rows`.
SurfacePoints Subset(const SurfacePoints& all, const std::vector<int>& rows);

// Returns the points for which keep(row) is true.
template <typename Keep>
SurfacePoints Filtered(const SurfacePoints& all, const Keep& keep) {
  std::vector<int> rows;
  for (int row = 0; row < all.size(); ++row) {
    if (keep(row)) rows.push_back(row);
  }
  return Subset(all, rows);
}

}  // namespace musclewarp
