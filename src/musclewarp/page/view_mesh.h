// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// A simplified mesh, good enough to look at: bones from CT have a hundred
// thousand triangles, which would make up most of a page.
struct ViewMesh {
  TriangleSoup soup;
  // The largest distance of a vertex of the original to the simplified
  // surface, mm.
  double max_error = 0;
};

// Simplifies a mesh to about `max_triangles` triangles at most, by collapsing
// the edges with the least quadric error (Garland and Heckbert 1997, the
// decimater of OpenMesh). A mesh that is small enough already, or not a closed
// 2-manifold, is returned as it is.
ViewMesh ViewMeshOf(const TriangleSoup& soup, int max_triangles);

}  // namespace musclewarp
