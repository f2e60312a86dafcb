// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Small closed meshes, outward oriented, for tests.

// Corners (0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1); volume 1/6.
TriangleSoup UnitTetrahedron();

// Centred box with edges of the given lengths, two triangles a face.
TriangleSoup Box(double x, double y, double z);

// An icosahedron subdivided `levels` times, corners on the sphere:
// 10 * 4^levels + 2 vertices.
TriangleSoup Icosphere(double radius, int levels);

// An icosphere stretched along z with half axes (radius, radius, half_length):
// the plainest muscle.
TriangleSoup Spindle(double radius, double half_length, int levels);

}  // namespace musclewarp
