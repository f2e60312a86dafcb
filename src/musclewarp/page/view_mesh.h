// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// A mesh with fewer triangles, good enough to look at.
struct ViewMesh {
  TriangleSoup soup;
  // Largest distance of a vertex of the original to it, mm.
  double max_error = 0;
};

// At most about `max_triangles` triangles, by collapsing edges at the least
// quadric error (Garland and Heckbert 1997, OpenMesh's decimater). A mesh that
// is small enough, or no 2-manifold, comes back as it is.
ViewMesh ViewMeshOf(const TriangleSoup& soup, int max_triangles);

}  // namespace musclewarp
