// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/initial_separation/medial_cell.h"
#include "musclewarp/initial_separation/solid_distance.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

struct CellSurfaceOptions {
  MedialCellOptions cell;

  // The spacing of the samples of a cell, mm. All cells of a scene need the
  // same spacing, so that their surfaces do not cross each other.
  double spacing = 1;

  // The radius of tubes around triangles that cross each other, in spacings; 0:
  // none. The tubes bridge places where self-crossings pinch the muscle off;
  // they have to be wide enough to contain samples.
  double bridge = 0;

  bool IsValid(std::string* error) const;
};

// Returns a new surface (mm) for a muscle that cannot be separated from others
// by moving its vertices: because a bone cuts through it, a tendon lies inside
// a bone, or the mesh crosses itself. The surface is the boundary of the
// largest part of the muscle within its medial cell: a closed, outward oriented
// manifold that does not cross itself, with many small triangles. Where the
// mesh crosses itself, its interior may be pinched off, so that a tendon and
// everything beyond it is lost (CellSurfaceOptions::bridge prevents this). The
// surface has no vertices if nothing of the muscle remains. Precondition
// (CHECKed): the options are valid.
TriangleSoup CellSurface(const CellSurfaceOptions& options,
                         const SolidDistance& muscle,
                         const std::vector<const SolidDistance*>& other_muscles,
                         const std::vector<const SolidDistance*>& bones);

// Deletes all components of closed surfaces except the one with the largest
// volume.
void KeepLargestBody(TriangleSoup* soup);

// Returns such a surface with triangles of uniform size, with edges of
// `edge_length` (mm), except in thin parts and narrow creases: where large
// triangles would cross, it keeps the small ones. The edges are shorter if the
// surface would otherwise lose more than 5 % of its volume. Returns the surface
// unchanged if crossings cannot be avoided. Since triangles cut corners, the
// result may cross other meshes slightly. Precondition (CHECKed): the length is
// above zero.
TriangleSoup WithEvenTriangles(const TriangleSoup& surface, double edge_length);

}  // namespace musclewarp
