// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Returns the same surface with every triangle split into four at the midpoints
// of its edges: #V + #edges points and 4 #F triangles. The first #V points are
// those of the mesh, unchanged; midpoints follow, and are shared by the
// triangles of an edge. Area and volume change only by rounding.
TriangleSoup MidpointRefined(const TriangleSoup& mesh);

// Returns true for the densities that WithDensity() supports: 0.25, 1, 4 and
// 16.
bool IsDensity(double density);

// Returns a mesh with `density` times as many triangles. Above 1 triangles are
// split at midpoints, and the surface stays the same. With 0.25 edges are
// collapsed (Decimated), and the surface stays nearly the same; a mesh that is
// not a closed manifold is returned unchanged. Precondition (CHECKed):
// IsDensity(density).
TriangleSoup WithDensity(const TriangleSoup& mesh, double density);

}  // namespace musclewarp
