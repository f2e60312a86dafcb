// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Returns a closed manifold with as few self-intersections as
// remove_self_intersections of CGAL leaves, which smooths small patches around
// them, or cuts them out and fills the holes. It may leave some, and holes,
// too; vertices and triangles elsewhere keep their places and order.
// Precondition (CHECKed): the mesh is a manifold.
TriangleSoup WithSelfIntersectionsRepaired(const TriangleSoup& soup);

}  // namespace musclewarp
