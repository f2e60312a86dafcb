// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Places on a surface, each in a triangle, and the points that they were looked
// up for, relative to them.
struct SurfacePlaces {
  std::vector<int> triangles;   // #places
  Points barycentric;           // #places x 3, weights of the corners
  Points offsets;               // #places x 3, mm, in the frame of the triangle
  double largest_distance = 0;  // of a point from its place, mm
};

// Finds the place of a surface that is nearest to each vertex of another, among
// triangles that face the way the vertex does: in a thin muscle those of the
// other side are near, too. Preconditions: `surface` has triangles, and `from`
// is closed.
SurfacePlaces NearestPlaces(const TriangleSoup& surface,
                            const TriangleSoup& from);

// Returns where points are, #places x 3, mm, that go with the places of a
// surface whose vertices are at `deformed` (#V x 3): interpolated linearly in
// the triangle, and as far from it as they were, so that rigid moves are exact.
Points CarriedPoints(const SurfacePlaces& places,
                     const Triangles& triangles,
                     const Points& deformed);

}  // namespace musclewarp
