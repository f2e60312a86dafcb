// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Places on a surface, each in a triangle, with the positions relative to them
// of the points from which they were found.
struct SurfacePlaces {
  std::vector<int> triangles;   // #places
  Points barycentric;           // #places x 3, weights of the corners
  Points offsets;               // #places x 3, mm, in the frame of the triangle
  double largest_distance = 0;  // of a point from its place, mm
};

// Returns the nearest place on a surface to each vertex of another surface,
// among triangles that face the same way as the vertex: the opposite side of a
// thin muscle is also near. Preconditions: `surface` has triangles, and `from`
// is closed.
SurfacePlaces NearestPlaces(const TriangleSoup& surface,
                            const TriangleSoup& from);

// Returns the positions (#places x 3, mm) of the points that belong to places
// of a surface whose vertices are at `deformed` (#V x 3). Places are
// interpolated linearly in their triangles, and points keep their offsets from
// them, so that rigid motions are reproduced exactly.
Points CarriedPoints(const SurfacePlaces& places,
                     const Triangles& triangles,
                     const Points& deformed);

}  // namespace musclewarp
