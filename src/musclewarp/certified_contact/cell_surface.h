// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/certified_contact/medial_cell.h"
#include "musclewarp/geometry/solid_distance.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

struct CellSurfaceOptions {
  MedialCellOptions cell;

  // Cells are sampled at this distance, mm. All cells of a scene need the same
  // one, so that their surfaces do not cross each other.
  double spacing = 1;

  bool IsValid(std::string* error) const;
};

// Returns a new surface for a muscle that cannot be separated from others by
// moving its vertices: because a bone cuts a part off, a tendon lies inside a
// bone, or the mesh crosses itself. It is the border of the largest part of the
// muscle that lies in its medial cell: a closed, outward oriented manifold that
// does not cross itself, with many small triangles. Without vertices if nothing
// of the muscle is left. Precondition (CHECKed): the options are valid.
TriangleSoup CellSurface(const CellSurfaceOptions& options,
                         const SolidDistance& muscle,
                         const std::vector<const SolidDistance*>& other_muscles,
                         const std::vector<const SolidDistance*>& bones);

// Returns such a surface with even triangles: the largest, from edges of
// `longest` down to `shortest` (mm), with which it does not cross itself, as
// thin parts may not survive large triangles. The surface as it is if there are
// none. Where triangles cut corners, it may come to cross other meshes a
// little. Precondition (CHECKed): both lengths are above zero.
TriangleSoup WithEvenTriangles(const TriangleSoup& surface,
                               double shortest,
                               double longest);

}  // namespace musclewarp
