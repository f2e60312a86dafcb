// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// V(X) = 1/6 sum (x_a x x_b) . x_c, paper eq. (2.6); mm^3, positive when the
// triangles face outward. Exact under translation only for closed meshes.
double SignedVolume(const Points& points, const Triangles& triangles);

// dV/dX, #V x 3, mm^2: the row of vertex i is 1/6 sum (x_b x x_c) over the
// triangles (i, b, c); paper eq. (2.10), J_g.
Points VolumeGradient(const Points& points, const Triangles& triangles);

// mm^2.
double SurfaceArea(const Points& points, const Triangles& triangles);

// Diagonal of the axis-aligned bounding box, mm; 0 for no points.
double BoundingBoxDiagonal(const Points& points);

}  // namespace musclewarp
