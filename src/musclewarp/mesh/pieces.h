// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Returns the pieces of a mesh that are connected through edges, in the order
// of their first triangles. Each has its own points, in the order of the mesh.
std::vector<TriangleSoup> PiecesOf(const TriangleSoup& soup);

// Returns one mesh of several, with their points and triangles in order.
TriangleSoup Joined(const std::vector<TriangleSoup>& pieces);

// Returns the volume that a piece encloses, mm^3, positive if its triangles
// face outward. An open piece is closed by a cone over its border, with the tip
// in the mean of the border's points, so that a flat hole is closed as if by a
// lid. Precondition: the triangles are consistently oriented.
double EnclosedVolume(const TriangleSoup& piece);

}  // namespace musclewarp
