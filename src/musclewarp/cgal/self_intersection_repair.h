// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Returns a mesh with the self-intersections of some triangles repaired where
// CGAL can do so (remove_self_intersections): small patches around them are
// smoothed, or cut out and filled again. Vertices and triangles elsewhere keep
// their places and order. Self-intersections and holes may be left, for which
// callers have to look. `triangles`: their numbers, wide around those that
// cross; the others are not looked at. Precondition (CHECKed): the mesh is a
// manifold.
TriangleSoup WithSelfIntersectionsRepaired(const TriangleSoup& soup,
                                           const std::vector<int>& triangles);

}  // namespace musclewarp
