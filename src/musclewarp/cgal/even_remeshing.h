// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Returns a closed surface with triangles of one size: edges are split,
// collapsed and flipped until they are about `edge_length` long, mm, and the
// vertices are spread evenly over the old surface (Botsch and Kobbelt 2004, "A
// Remeshing Approach to Multiresolution Modeling"; isotropic_remeshing of
// CGAL). The new vertices lie on the old surface, and its details below the
// edge length are lost. Triangles for which `is_kept` (#F, or empty for none)
// is true stay as they are, but for edges of more than 4/3 of the edge length.
// Preconditions (CHECKed): the mesh is a manifold, the edge length is
// above zero.
TriangleSoup Remeshed(const TriangleSoup& soup,
                      double edge_length,
                      const std::vector<bool>& is_kept = {});

}  // namespace musclewarp
