// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Below these angles a surface forces small angles on the tetrahedra beside it,
// as all its triangles stay.
constexpr double kSharpTriangleDeg = 10;  // between edges of a triangle
constexpr double kSharpEdgeDeg = 15;      // inside, between triangles

// Returns for each point of a closed surface whether it is a corner of a
// triangle or an end of an edge with a smaller angle.
std::vector<bool> SharpPoints(const TriangleSoup& surface);

}  // namespace musclewarp
