// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Returns the triangles of `a` that `b` does not have: those whose corners are
// not those of a triangle of `b` in any order, to the last bit of their
// coordinates. Triangles of which two corners are one point are left out, as
// they add nothing to the surface. The points are those in use.
TriangleSoup TrianglesNotIn(const TriangleSoup& a, const TriangleSoup& b);

// Returns true if two meshes have the same points and triangles in the same
// order, to the last bit.
bool AreSame(const TriangleSoup& a, const TriangleSoup& b);

}  // namespace musclewarp
