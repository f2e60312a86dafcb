// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Returns the same surface with every triangle cut into four at the midpoints
// of its edges: #V + #edges points and 4 #F triangles. The first #V points are
// those of the mesh, unchanged; midpoints follow, and are shared by the
// triangles of an edge. Area and volume change by rounding only.
TriangleSoup MidpointRefined(const TriangleSoup& mesh);

// True for the densities that WithDensity() can make: 0.25, 1, 4 and 16.
bool IsDensity(double density);

// Returns a mesh with `density` times as many triangles, 0.25, 1, 4 or 16.
// Above 1 it is refined by midpoints, and the surface is the same. With 0.25
// edges are collapsed (ViewMeshOf), and the surface is nearly the same; a mesh
// that is not a closed manifold stays as it is. Precondition (CHECKed):
// IsDensity(density).
TriangleSoup WithDensity(const TriangleSoup& mesh, double density);

}  // namespace musclewarp
