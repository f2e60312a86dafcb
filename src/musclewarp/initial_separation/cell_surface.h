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

  // Cells are sampled at this distance, mm. All cells of a scene need the same
  // one, so that their surfaces do not cross each other.
  double spacing = 1;

  // The radius of the tubes around triangles that cross each other, which
  // bridge places where the muscle is pinched off, in spacings, so that samples
  // lie in them; 0: none.
  double bridge = 0;

  bool IsValid(std::string* error) const;
};

// Returns a new surface for a muscle that cannot be separated from others by
// moving its vertices: because a bone cuts a part off, a tendon lies inside a
// bone, or the mesh crosses itself. It is the border of the largest part of the
// muscle that lies in its medial cell: a closed, outward oriented manifold that
// does not cross itself, with many small triangles. Where the mesh crosses
// itself its inside may be pinched off, so that a tendon is lost with all that
// lies beyond (CellSurfaceOptions::bridge). Without vertices if nothing of the
// muscle is left. Precondition (CHECKed): the options are valid.
TriangleSoup CellSurface(const CellSurfaceOptions& options,
                         const SolidDistance& muscle,
                         const std::vector<const SolidDistance*>& other_muscles,
                         const std::vector<const SolidDistance*>& bones);

// Deletes all components of closed surfaces but the one that encloses the
// largest volume.
void KeepLargestBody(TriangleSoup* soup);

// Returns such a surface with triangles of one size, edges of `edge_length`,
// mm, but for its thin parts and narrow creases: where it would cross itself
// with large triangles, it keeps the small ones. The edges of a surface that
// would lose more than 5 % of its volume are shorter. Returns the surface as it
// is if that does not help. Where triangles cut corners, it may come to cross
// other meshes a little. Precondition (CHECKed): the length is above zero.
TriangleSoup WithEvenTriangles(const TriangleSoup& surface, double edge_length);

}  // namespace musclewarp
